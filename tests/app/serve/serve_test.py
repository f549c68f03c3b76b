"""The example clients against `abstand serve`: nothing unanswered, a stop when input ends, no harm by random bytes.

    serve_test.py PROGRAM CPP_CLIENT
"""
import json
import math
import os
import pathlib
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "docs" / "clients"))
import serve_client as client  # noqa: E402

PROGRAM = sys.argv.pop(1)
CPP_CLIENT = sys.argv.pop(1)
SCENE = """abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.1}}}]
humans:
  - {name: operator}
"""
SLIDE = "chain\n    frame   1   0      0          d    0\nend_chain\n"
STALE = 0.15  # s
# s beyond which a stop is late, however busy the machine is.
ALLOWANCE = 5.0
PLACE = (1.5, 0.0, 0.0)


class Serve(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        path = pathlib.Path(folder.name)
        (path / "slide.mech").write_text(SLIDE)
        (path / "scene.yaml").write_text(SCENE)
        cls.scene = str(path / "scene.yaml")
        # Structures are built once for all tests.
        cls.environment = dict(os.environ, ABSTAND_CACHE=str(path / "cache"))

    def setUp(self):
        self.program = None

    def tearDown(self):
        if self.program and self.program.poll() is None:
            self.program.kill()
            self.program.communicate()

    def start(self, *options, stdin=None, stale=STALE):
        self.program = subprocess.Popen(
            [PROGRAM, "serve", self.scene, "--bind", "127.0.0.1:0", "--json", "--duration", "60", "--stale", str(stale),
             *options],
            stdin=stdin, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment)
        listening = self.program.stderr.readline()
        match = re.fullmatch(r"serve: listening on 127\.0\.0\.1:(\d+)\n", listening)
        self.assertTrue(match, listening)
        return self.client(int(match.group(1)))

    def client(self, port):
        c = client.Client("127.0.0.1", port)
        self.addCleanup(c.socket.close)
        return c

    def finish(self):
        self.program.send_signal(signal.SIGINT)
        out, err = self.program.communicate(timeout=60)
        self.assertEqual(self.program.returncode, 130, err)
        self.assertEqual(err, "")
        return json.loads(out)

    def test_every_packet_is_answered(self):
        c = self.start()
        trips, unanswered = client.measure(c, joints=1, people=1, seconds=1.0, rate=1000.0, place=PLACE)
        self.assertEqual(unanswered, 0)
        self.assertEqual(len(trips), 1000)
        summary = self.finish()
        self.assertEqual(summary["joints"], 1000)
        self.assertEqual(summary["answered"], 1000)
        self.assertEqual(summary["skeletons"], 100)
        self.assertEqual((summary["bad"], summary["late"], summary["lost"], summary["duplicates"]), (0, 0, 0, 0))
        self.assertTrue(summary["interrupted"])
        self.assertGreater(summary["cycle_us"]["median"], 0)
        self.assertEqual(summary["joint_limits"], [])

    def test_every_packet_of_the_cpp_client_is_answered(self):
        port = self.start().socket.getpeername()[1]
        run = subprocess.run([CPP_CLIENT, str(port), "1", "1", "0.5", "1000"], capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        summary = self.finish()
        self.assertEqual((summary["joints"], summary["answered"]), (500, 500))
        self.assertEqual(summary["skeletons"], 50)
        self.assertEqual(summary["bad"], 0)

    def test_a_proxy_needs_something_that_is_held(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "reaction.yaml"
            file.write_text("proxy: {stiffness: 1000}\n")
            run = subprocess.run([PROGRAM, "serve", self.scene, "--reaction", str(file)], capture_output=True,
                                 text=True, env=self.environment)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn("expected one of its `links` with `held: true`", run.stderr)

    def stop_after(self, keep_joints):
        """Seconds from the last skeleton (and joints) to the answer that tells of a stop, and its robot."""
        c = self.start("--resume", "0")
        begin = time.monotonic()
        running = False
        while not running and time.monotonic() - begin < ALLOWANCE:
            last = time.monotonic()
            c.skeleton(0, [(x + PLACE[0], y, z) for x, y, z in client.STANDING])
            c.joints([0.0])
            answer = c.receive(0.5)
            running = answer is not None and client.robot_of(answer, 0, 1)["state"] == "running"
        self.assertTrue(running)
        while time.monotonic() - last < ALLOWANCE:
            if keep_joints:
                c.joints([0.0])
            answer = c.receive(0.01)
            robot = answer and client.robot_of(answer, 0, 1)
            if robot and robot["state"] != "running":
                return time.monotonic() - last, robot
        self.fail("no stop")

    def test_pulling_all_input_stops_the_robot(self):
        seconds, robot = self.stop_after(keep_joints=False)
        self.assertLess(seconds, STALE + ALLOWANCE)
        self.assertEqual(robot["speed_scale"], 0.0)
        self.assertIn(robot["reason"], (3, 4))  # stale input or lost person: both went at once
        stops = self.finish()["stops"]
        self.assertIn("protective stop", [s["to"] for s in stops])

    def test_pulling_the_skeleton_stops_the_robot(self):
        seconds, robot = self.stop_after(keep_joints=True)
        self.assertLess(seconds, STALE + ALLOWANCE)
        self.assertEqual(robot["speed_scale"], 0.0)
        self.assertEqual(robot["reason"], 4)  # lost person
        self.assertIn("lost person", [s["reason"] for s in self.finish()["stops"]])

    def test_groups_of_pairs_and_torques_are_controlled(self):
        c = self.start("--resume", "0")
        panel = self.client(c.socket.getpeername()[1])

        def order(sequence, **fields):
            panel.socket.send(json.dumps({"type": "control", "seq": sequence, "time_us": 0, **fields}).encode())
            answer = panel.receive(ALLOWANCE)
            self.assertIsNotNone(answer)
            return json.loads(answer)

        answer = order(1, do="report")
        self.assertTrue(answer["done"] and answer["torques_on"])
        self.assertEqual({g["state"] for g in answer["groups"]}, {"running"})
        self.assertIn("slide - operator", [g["name"] for g in answer["groups"]])
        answer = order(2, do="pause", group="slide - operator")
        self.assertIn({"name": "slide - operator", "state": "paused", "pairs": 14}, answer["groups"])
        c.joints([0.0])
        state = c.receive(ALLOWANCE)
        self.assertEqual(client.HEADER.unpack_from(state)[6] & 24, 16)
        self.assertNotEqual(client.robot_of(state, 0, 1)["state"], "running")
        answer = order(3, do="add", group="slide - operator", a="ball", b="operator/head")
        self.assertEqual((answer["done"], answer["reason"]), (False, "the pair is in a group already"))
        self.assertTrue(order(4, do="run")["done"])
        # The same in bytes: torques off.
        panel.sequence[4, 0] = 5
        panel.send(4, 0, struct.pack("<4I", 7, 0xFFFFFFFF, 0, 0))
        answer = panel.receive(ALLOWANCE)
        self.assertEqual(client.HEADER.unpack_from(answer)[2:4], (5, 5))
        self.assertEqual(struct.unpack_from("<2I", answer, 40), (0, 0))
        c.joints([0.0])
        state = c.receive(ALLOWANCE)
        self.assertEqual(client.HEADER.unpack_from(state)[6] & 24, 8)
        panel.socket.send(b'{"type":"control","seq":6,"time_us":0,"do":"pause","group":"nobody"}')
        summary = self.finish()
        self.assertEqual(summary["controls"], 5)
        self.assertEqual(summary["bad_by_reason"]["index"], 1)

    def test_random_bytes_do_no_harm(self):
        c = self.start()
        noise = self.client(c.socket.getpeername()[1])
        dice = random.Random(1)
        begin = b"ABST\x01\x00\x01\x00"
        sent = 0

        def bother(answer):
            nonlocal sent
            body = dice.randbytes(dice.randrange(200))
            noise.socket.send(dice.choice((b"", b"{", begin)) + body)
            sent += 1

        trips, unanswered = client.measure(c, 1, 1, seconds=0.5, rate=1000.0, place=PLACE, on_answer=bother)
        self.assertEqual(unanswered, 0)
        noise.socket.send(b"")
        c.joints([math.nan])
        c.joints([1.0, 2.0])
        c.joints([1.0], index=7)
        c.joints([0.5])
        answer = c.receive(5.0)
        while answer is not None and client.sequence_of(answer) != c.sequence[client.JOINTS, client.ALL] - 1:
            answer = c.receive(5.0)
        self.assertIsNotNone(answer)
        self.assertEqual(client.server_of(answer)["bad"], sent + 4)
        summary = self.finish()
        self.assertEqual(summary["bad"], sent + 4)
        self.assertEqual(summary["answered"], len(trips) + 1)
        self.assertGreaterEqual(summary["bad_by_reason"]["number"], 1)
        self.assertGreaterEqual(summary["bad_by_reason"]["json"], 1)

    def skeleton_line(self, sequence, **changes):
        joints = {name: [x + PLACE[0], y, z] for name, (x, y, z) in zip(
            ["pelvis", "spine", "thorax", "neck", "head", "head_top"] +
            [j + side for side in ("_left", "_right") for j in ("shoulder", "elbow", "wrist", "hand")] +
            [j + side for side in ("_left", "_right") for j in ("hip", "knee", "ankle", "toe")], client.STANDING)}
        line = {"type": "skeleton", "seq": sequence, "time_us": 0, "person": "operator", "joints": joints}
        return json.dumps({**line, **changes})

    def test_skeletons_from_standard_input(self):
        c = self.start("--stdin", "--resume", "0", stdin=subprocess.PIPE)
        lines = self.program.stdin
        for bad in ("hello", "", "{", self.skeleton_line(1, person="nobody"), "x" * 100000,
                    json.dumps({"type": "joints", "seq": 5, "time_us": 0, "q": [0.25]})):
            lines.write(bad + "\n")
        begin = time.monotonic()
        sequence, running = 0, False
        while not running and time.monotonic() - begin < ALLOWANCE:
            lines.write(self.skeleton_line(sequence) + "\n")
            lines.flush()
            sequence += 1
            c.joints([0.0])
            answer = c.receive(0.5)
            running = answer is not None and client.robot_of(answer, 0, 1)["state"] == "running"
        self.assertTrue(running)
        # The end of the input is a person who is not seen any more.
        lines.close()
        self.program.stdin = None
        begin, robot = time.monotonic(), None
        while time.monotonic() - begin < ALLOWANCE and (robot is None or robot["state"] == "running"):
            c.joints([0.0])
            answer = c.receive(0.01)
            robot = client.robot_of(answer, 0, 1) if answer else robot
        self.assertNotEqual(robot["state"], "running")
        self.assertEqual(robot["reason"], 4)  # lost person
        self.assertEqual(robot["speed_scale"], 0.0)
        summary = self.finish()
        self.assertEqual(summary["skeletons"], sequence)
        self.assertEqual(summary["lines"], sequence + 5)
        self.assertEqual(summary["bad"], 5)
        reasons = {k: v for k, v in summary["bad_by_reason"].items() if v}
        self.assertEqual(reasons, {"json": 2, "index": 1, "size": 1, "type": 1})

    def test_lines_of_json(self):
        c = self.start()
        c.socket.send(self.skeleton_line(0).encode())
        c.socket.send(json.dumps({"type": "joints", "seq": 5, "time_us": 0, "q": [0.25]}).encode())
        state = json.loads(c.receive(5.0))
        self.assertEqual(state["seq"], 5)
        self.assertEqual(state["mechanisms"][0]["state"], "running")
        self.assertEqual(state["bad"], 0)
        # The ball of 0.1 m at the height of the calves, the person 1.5 m away: nearer than that, not by far.
        self.assertGreater(state["separation"][0]["distance"], 1.0)
        self.assertLess(state["separation"][0]["distance"], 1.4)
        self.finish()

    def test_a_free_running_loop(self):
        c = self.start("--rate", "200")
        c.joints([0.0])
        for _ in range(5):
            answer = c.receive(5.0)
            self.assertIsNotNone(answer)
            self.assertIsNone(client.sequence_of(answer))  # answers no packet
        self.assertGreaterEqual(self.finish()["unasked"], 5)

    def test_layout_is_a_table(self):
        out = subprocess.run([PROGRAM, "serve", self.scene, "--layout"], capture_output=True, text=True, check=True,
                             env=self.environment).stdout
        self.assertIn("joints of slide: 40 bytes", out)
        self.assertIn("skeleton of a person: 584 bytes", out)
        self.assertIn("state, the answer: 880 bytes", out)
        layout = json.loads(subprocess.run([PROGRAM, "serve", self.scene, "--layout", "--json"], capture_output=True,
                                           text=True, check=True, env=self.environment).stdout)
        self.assertEqual([p["bytes"] for p in layout["packets"]],
                         [40, 584, 880, 48, 56 + 8 * len(layout["groups"])])
        self.assertGreater(len(layout["groups"]), 0)
        for packet in layout["packets"]:  # fields fill the packet without a gap
            last = packet["fields"][-1]
            self.assertEqual(last["offset"] + int(last["type"][1:]) // 8, packet["bytes"])
        self.assertEqual(layout["packets"][0]["fields"][-1],
                         {"offset": 32, "type": "f64", "meaning": "slide.q0, rad or m"})
        self.assertEqual(layout["states"][0], "running")
        self.assertEqual(layout["schema_version"], 1)

    def test_every_joint_value_has_one_sender(self):
        c = self.start(stale=30.0)
        other = self.client(c.socket.getpeername()[1])
        c.joints([0.1])
        self.assertIsNotNone(c.receive(5.0))
        for _ in range(20):
            c.joints([0.1])
            other.joints([0.9], index=0)
            self.assertIsNotNone(c.receive(5.0))
        self.assertIsNone(other.receive(0.05))
        summary = self.finish()
        self.assertEqual(summary["bad_by_reason"]["foreign"], 20)
        self.assertEqual(summary["joints"], 21)

    def test_terminate_and_hang_up_end_like_ctrl_c(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            self.start()
            self.program.send_signal(number)
            out, err = self.program.communicate(timeout=60)
            self.assertEqual(self.program.returncode, 130, err)
            self.assertTrue(json.loads(out)["interrupted"])

    def test_wrong_usage(self):
        for bad in (["--bind", "localhost"], ["--stale", "0"], ["--rate", "none"], ["--bind", "203.0.113.1:5"],
                    ["--nearest", "-1"]):
            run = subprocess.run([PROGRAM, "serve", self.scene, *bad], capture_output=True, text=True,
                                 env=self.environment)
            self.assertEqual(run.returncode, 2, bad)
            self.assertEqual(run.stderr.count("error:"), 1, bad)


if __name__ == "__main__":
    unittest.main(verbosity=1)
