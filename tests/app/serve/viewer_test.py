"""The example viewer against the real program: what it shows is what the server answers to its client.

    viewer_test.py PROGRAM
"""
import json
import os
import pathlib
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
root = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(root / "docs" / "clients"))
import serve_client as client  # noqa: E402
import serve_viewer as viewer  # noqa: E402

PROGRAM = sys.argv.pop(1)
SCENE = """abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    links: [{name: ball, frame: 1, margin: 0.07, shape: {sphere: {radius: 0.1}}}]
objects:
  - {name: plate, shape: {cuboid: {size: [1, 1, 0.2]}}, pose: {xyz: [0, 0, -0.1]}}
"""
SLIDE = "chain\n    frame   1   0      0          d    0\nend_chain\n"
# s beyond which something does not come at all, however busy the machine is.
ALLOWANCE = 30.0
# One nearest pair, without people: 64 bytes, a robot of 32, a joint of 8, a link of 48, then the pair's distance.
DISTANCE_AT = 64 + 32 + 8 + 48 + 16


class Viewing(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        (self.path / "slide.mech").write_text(SLIDE)
        (self.path / "scene.yaml").write_text(SCENE)

    def serve(self, *options, stale="10"):
        server = subprocess.Popen(
            [PROGRAM, "serve", str(self.path / "scene.yaml"), "--bind", "127.0.0.1:0", "--json", "--resume", "0", "--nearest", "1", "--duration", "100", "--stale", stale, *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            env=dict(os.environ, ABSTAND_CACHE=str(self.path / "cache")))
        self.addCleanup(lambda: (server.kill(), server.communicate()))
        line = server.stderr.readline()
        self.assertIn("serve: listening on 127.0.0.1:", line)
        return server, int(line.rsplit(":", 1)[1])

    def robot(self, port):
        robot = client.Client("127.0.0.1", port)
        self.addCleanup(robot.socket.close)
        return robot

    def viewer(self, port, rate=60.0):
        v = viewer.Viewer("127.0.0.1", port, rate)
        self.addCleanup(v.socket.close)
        return v

    def test_moments_are_the_answers(self):
        server, port = self.serve()
        robot, first, second = self.robot(port), self.viewer(port), self.viewer(port, 30.0)
        answers, moments, others = {}, [], []
        begin = time.monotonic()
        while len(moments) < 60 or len(others) < 20:
            self.assertLess(time.monotonic() - begin, ALLOWANCE)
            q = 0.2 + 0.3 * ((time.monotonic() - begin) % 1.0)
            robot.joints([q])
            answer = robot.receive(0.05)
            if answer is None:
                continue
            answers[client.server_of(answer)["time_us"]] = (q, struct.unpack_from("<d", answer, DISTANCE_AT)[0])
            for v, into in ((first, moments), (second, others)):
                got = v.moment(0.0)
                if got:
                    into.append(got)
        self.assertEqual(first.scene["objects"], ["ball", "plate"])
        self.assertEqual(first.scene["pairs"], [(0, 1)])
        self.assertEqual(first.scene["file"], str(self.path / "scene.yaml"))
        matched = 0
        for _, moment in moments + others:
            # Microseconds are cut, not rounded.
            known = [answers[k] for k in (int(1e6 * moment["t"]), round(1e6 * moment["t"])) if k in answers]
            if not known:
                continue
            q, distance = known[0]
            matched += 1
            pair, ball = moment["pairs"][0], moment["objects"][0]
            self.assertEqual(pair[0], distance)
            self.assertEqual(moment["joints"][0][0], q)
            self.assertEqual(ball[11], q)  # its height
            self.assertAlmostEqual(pair[0], q - 0.1, delta=pair[1] + 1e-9)
            self.assertEqual(pair[2], 0.07)
        self.assertGreater(matched, 40)
        sequences = [header[3] for header, _ in moments]
        self.assertEqual(sequences, sorted(set(sequences)))
        # Decimated to what was asked for; some answers pass between two moments.
        self.assertLess(len(moments), len(answers))
        server.send_signal(signal.SIGINT)
        summary = json.loads(server.communicate(timeout=60)[0])
        self.assertEqual(summary["viewers"]["accepted"], 2)
        self.assertEqual(summary["viewers"]["bad"], 0)
        self.assertEqual(summary["bad"], 0)

    def test_an_idle_server_is_alive_and_a_killed_one_closes(self):
        server, port = self.serve(stale="0.2")
        v = self.viewer(port)
        self.assertIsNotNone(v.moment(ALLOWANCE))
        self.assertIsNone(v.moment(1.0))
        self.assertGreater(v.alive, 3)
        server.kill()
        begin = time.monotonic()
        v.socket.settimeout(ALLOWANCE)
        try:
            while v.socket.recv(65536):
                self.assertLess(time.monotonic() - begin, ALLOWANCE)
        except ConnectionResetError:
            pass

    def test_wrong_frames_are_refused(self):
        server, port = self.serve()
        for change in ({0: 0}, {4: 2}, {6: 8}, {28: 7}, {39: 0xFF, 38: 0xFF}):
            v = self.viewer(port)
            frame = bytearray(viewer.HEADER.pack(b"ABST", 1, viewer.WATCH, 0, 0, 0, 0, 40) + struct.pack("<d", 60.0))
            for at, value in change.items():
                frame[at] = value
            v.socket.sendall(frame)
            v.socket.settimeout(ALLOWANCE)
            try:
                self.assertEqual(v.socket.recv(1), b"", change)
            except ConnectionResetError:
                pass
        server.send_signal(signal.SIGINT)
        self.assertEqual(json.loads(server.communicate(timeout=60)[0])["viewers"]["bad"], 5)

    def test_without_viewers_there_is_no_port(self):
        server, port = self.serve("--viewers", "0")
        with self.assertRaises(ConnectionRefusedError):
            viewer.Viewer("127.0.0.1", port)
        server.send_signal(signal.SIGINT)
        self.assertIsNone(json.loads(server.communicate(timeout=60)[0])["viewers"])


if __name__ == "__main__":
    unittest.main()
