"""A camera, the tracker, the server and a robot: fakenect plays a simulated person through the driver's interface.

    live_test.py PROGRAM FAKENECT KINECTS
(FAKENECT: a libfreenect that plays recordings; KINECTS: one of the tests that has several cameras; empty where there is none)
"""
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True
root = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(root / "docs" / "clients"))
import serve_client as client  # noqa: E402

PROGRAM = sys.argv.pop(1)
FAKENECT = sys.argv.pop(1)
KINECTS = sys.argv.pop(1)
SCENE = """abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    base: {xyz: [-1.5, 0, 0]}
    links: [{name: ball, frame: 1, shape: {sphere: {radius: 0.1}}}]
humans:
  - {name: visitor, height: 1.75}
"""
# Of the person alone, as the camera sees one, with the structures of the one above.
SHOWN = """abstand: 1
defaults: {voxel: 0.02, point: 0.02}
humans:
  - {name: visitor, height: 1.75}
"""
# A post beside the person, which stands at 0.6 m of a slide; the server serves another file of it.
POST = """abstand: 1
defaults: {voxel: 0.02, point: 0.02}
mechanisms:
  - name: slide
    file: slide.mech
    base: {xyz: [0.3, -0.5, 0], rpy: [0, 0, 0]}
    q: [%s]
    links: [{name: post, frame: 1, shape: {cuboid: {size: [0.2, 0.2, 0.9]}}}]
humans:
  - {name: visitor, height: 1.75}
"""
SLIDE = "chain\n    frame   1   0      0          d    0\nend_chain\n"
# s without a skeleton until the robot stops. Far more than between two images, so that a busy machine may pause.
STALE = 1.0
# s beyond which something did not come at all, however busy the machine is.
ALLOWANCE = 30.0


class Live(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.path = pathlib.Path(folder.name)
        (cls.path / "slide.mech").write_text(SLIDE)
        (cls.path / "scene.yaml").write_text(SCENE)
        cls.environment = dict(os.environ, ABSTAND_CACHE=str(cls.path / "cache"))
        (cls.path / "shown.yaml").write_text(SHOWN)
        cls.dump = cls.path / "dump"
        subprocess.run([PROGRAM, "render-depth", str(cls.path / "shown.yaml"), "--recording", str(root / "data/scenes/hug_reach.bvh"), 
                        "--format", "freenect", "--body", "skin", "--room", "--rate", "15", "--end", "1.4", "--out", str(cls.dump),
                        "--quiet"], check=True, env=cls.environment)
        # The driver says how its fake is found: by the loader's path, under the true library's name.
        cls.camera = dict(cls.environment, FAKENECT_PATH=str(cls.dump), LD_LIBRARY_PATH=os.path.dirname(FAKENECT))

    def track(self, *options, environment=None):
        return subprocess.run([PROGRAM, "track", "live:kinect", *options], capture_output=True, text=True,
                              env=environment or self.camera, timeout=100)

    def document(self, run):
        # fakenect tells of the end of its recording on standard output, too.
        return json.loads("".join(line for line in run.stdout.splitlines(True) if not line.startswith("Warning: ")))

    def test_from_the_camera_to_the_robot(self):
        server = subprocess.Popen(
            [PROGRAM, "serve", str(self.path / "scene.yaml"), "--bind", "127.0.0.1:0", "--json", "--stale", str(STALE),
             "--resume", "0", "--duration", "100"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.environment)
        self.addCleanup(lambda: (server.kill(), server.communicate()))
        port = re.fullmatch(r"serve: listening on 127\.0\.0\.1:(\d+)\n", server.stderr.readline()).group(1)
        robot = client.Client("127.0.0.1", int(port))
        self.addCleanup(robot.socket.close)
        tracker = subprocess.Popen(
            [PROGRAM, "track", "live:kinect", "--camera", str(self.dump / "camera.yaml"), "--height", "1.75",
             "--usual-body", "--send", "127.0.0.1:" + port, "--as", "visitor", "--json", "--out",
             str(self.path / "person.csv")], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.camera)
        self.addCleanup(lambda: (tracker.kill(), tracker.communicate()))
        begin, ran = time.monotonic(), False
        while time.monotonic() - begin < ALLOWANCE:
            robot.joints([0.0])
            answer = robot.receive(0.02)
            if answer is None:
                continue
            state = client.robot_of(answer, 0, 1)
            ran = ran or state["state"] == "running"
            if ran and state["state"] == "protective stop":
                break
        out, err = tracker.communicate(timeout=60)
        # The recording's end is a camera that goes: what was tracked is kept, and the robot stops for a lost person.
        self.assertEqual(tracker.returncode, 5, err)
        self.assertIn("found the camera disconnected after 22 images", err)
        self.assertTrue(ran, "the robot never ran")
        self.assertEqual(state["state"], "protective stop")
        self.assertEqual(state["reason"], 4)  # lost person
        track = json.loads("".join(line for line in out.splitlines(True) if not line.startswith("Warning: ")))
        self.assertEqual(track["frames"] + track["dropped"], 22)
        self.assertEqual(track["unsent"], 0)
        self.assertGreater(track["latency_ms"]["median"], 0.0)
        server.send_signal(signal.SIGINT)
        served = json.loads(server.communicate(timeout=60)[0])
        self.assertEqual(served["skeletons"], track["sent"])
        self.assertGreater(track["sent"], 0)
        self.assertEqual(served["bad"], 0)
        # What was written is what was sent: a skeleton where the simulated person stood.
        rows = (self.path / "person.csv").read_text()
        self.assertIn("pelvis", rows)

    def test_what_the_camera_shows_is_what_its_recording_shows(self):
        run = self.track("--camera", str(self.dump / "camera.yaml"), "--height", "1.75", "--usual-body", "--json",
                         "--seconds", "1")
        self.assertEqual(run.returncode, 0, run.stderr)
        live = self.document(run)
        file = json.loads(subprocess.run([PROGRAM, "track", str(self.dump), "--height", "1.75", "--usual-body", "--json"],
                                         capture_output=True, text=True, env=self.environment, check=True).stdout)
        self.assertEqual(live["world"], file["world"])
        self.assertEqual(len(live["people"]), len(file["people"]))
        # mm; the same images, of which the live walk may have dropped some.
        self.assertAlmostEqual(live["residual_mm"], file["residual_mm"], delta=3.0)
        self.assertIsNone(live["ended"])

    def test_lines_on_standard_output_are_those_of_serve(self):
        run = self.track("--camera", str(self.dump / "camera.yaml"), "--height", "1.75", "--usual-body", "--send", "-",
                         "--seconds", "0.5")
        self.assertEqual(run.returncode, 0, run.stderr)
        lines = [json.loads(line) for line in run.stdout.splitlines()]
        self.assertGreater(len(lines), 0)
        self.assertEqual([line["seq"] for line in lines], list(range(len(lines))))
        self.assertTrue(all(line["type"] == "skeleton" and line["person"] == "operator" for line in lines))

    def test_what_was_tracked_is_kept_when_the_reader_ends(self):
        csv = self.path / "kept.csv"
        reader, writer = os.pipe()
        os.close(reader)
        run = subprocess.run([PROGRAM, "track", "live:kinect", "--camera", str(self.dump / "camera.yaml"), "--height",
                              "1.75", "--usual-body", "--send", "-", "--out", str(csv)], stdout=writer,
                             stderr=subprocess.PIPE, text=True, env=self.camera, timeout=100)
        os.close(writer)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("standard output was closed", run.stderr)
        self.assertIn("pelvis", csv.read_text())

    def test_robots_are_removed_where_the_server_has_them(self):
        clip = self.path / "post"
        shown = self.path / "post.yaml"
        shown.write_text(POST % "0.6")
        subprocess.run([PROGRAM, "render-depth", str(shown), "--recording", str(root / "data/scenes/hug_reach.bvh"), "--format",
                        "freenect", "--body", "skin", "--room", "--rate", "15", "--end", "2.5", "--out", str(clip), "--quiet"],
                       check=True, env=self.environment)
        server = subprocess.Popen(
            [PROGRAM, "serve", str(shown), "--bind", "127.0.0.1:0", "--stale", str(ALLOWANCE), "--duration", "100"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, env=self.environment)
        self.addCleanup(lambda: (server.kill(), server.communicate()))
        port = re.search(r"listening on 127\.0\.0\.1:(\d+)", server.stderr.readline()).group(1)
        robot = client.Client("127.0.0.1", int(port))
        self.addCleanup(robot.socket.close)
        track = ["--camera", str(clip / "camera.yaml"), "--height", "1.75", "--usual-body", "--json", "--scene", str(shown)]
        camera = dict(self.camera, FAKENECT_PATH=str(clip))
        for height, shows in ((0.6, True), (1.6, False)):
            robot.joints([height])
            self.assertIsNotNone(robot.receive(ALLOWANCE))
            run = self.track(*track, "--robots", "127.0.0.1:" + port, environment=camera)
            self.assertEqual(run.returncode, 5, run.stderr)  # the recording's end
            live = self.document(run)
            things = live["cameras"][0]["things"]
            self.assertEqual(things["removed"], shows, (height, live["warnings"]))
            self.assertEqual(any("T_WC" in warning for warning in live["warnings"]), not shows, live["warnings"])
            self.assertEqual(len(live["people"]), 1)
            if shows:
                self.assertGreater(things["shown"], 0.9)
        # Before a server of another scene, and without any.
        other = self.path / "other_post.yaml"
        other.write_text(POST % "0.5")
        for options, says in ((["--scene", str(other), "--robots", "127.0.0.1:" + port], "another scene"),
                              (["--scene", str(shown)], "no server"), (["--robots", "127.0.0.1:" + port], "--scene"),
                              (["--scene", str(shown), "--robots", "nowhere"], "--robots")):
            run = self.track("--camera", str(clip / "camera.yaml"), *options, environment=camera)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertIn(says, run.stderr)

    @unittest.skipUnless(KINECTS, "built without libfreenect.h")
    def test_several_cameras_share_one_fit(self):
        clips = self.path / "clips"
        subprocess.run([PROGRAM, "render-depth", str(self.path / "shown.yaml"), "--recording",
                        str(root / "data/scenes/hug_reach.bvh"), "--format", "freenect", "--body", "skin", "--rate", "15", "--end",
                        "2.2", "--eye", "2.8,0,1.4", "--eye", "0,-2.8,1.4", "--look", "0,0,0.9", "--out", str(clips), "--quiet"],
                       check=True, env=self.environment)
        one, two = clips / "camera_1", clips / "camera_2"
        # The first camera goes after 0.8 s; the second one goes on alone, and that is said.
        names = (one / "INDEX.txt").read_text().splitlines()
        (one / "INDEX.txt").write_text("\n".join(names[:13]) + "\n")
        environment = dict(self.environment, FAKE_KINECT=f"play:{one},play:{two}", LD_LIBRARY_PATH=os.path.dirname(KINECTS))
        csv = self.path / "both.csv"
        run = subprocess.run([PROGRAM, "track", "live:kinect", "live:kinect:KINECT2", "--camera",
                              f"{one}/camera.yaml,{two}/camera.yaml", "--height", "1.75", "--usual-body", "--json", "--out", str(csv)],
                             capture_output=True, text=True, env=environment, timeout=100)
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertIn("looking through live:kinect and live:kinect:KINECT2", run.stderr)
        self.assertIn("live:kinect: found the camera disconnected after 13 images", run.stderr)
        self.assertIn("live:kinect:KINECT2: found the camera disconnected after 34 images", run.stderr)
        track = json.loads(run.stdout)
        self.assertEqual(len(track["people"]), 1)
        self.assertEqual([c["file"] for c in track["cameras"]], ["live:kinect", "live:kinect:KINECT2"])
        for camera in track["cameras"]:
            self.assertGreater(camera["images_with_people"], 0)
            self.assertIn("found the camera disconnected", camera["ended"])
        self.assertGreater(track["cameras"][0]["moments_without"], 0)
        self.assertGreater(track["tracked"], track["cameras"][0]["images"])
        for name in ("live:kinect: ", "live:kinect:KINECT2: "):
            self.assertEqual(sum(w.startswith(name) for w in track["warnings"]), 1, track["warnings"])
        self.assertIn("pelvis", csv.read_text())

    def test_what_is_wrong_is_one_sentence(self):
        broken = self.path / "broken"
        broken.mkdir()
        (broken / "libfreenect.so.0.5").write_text("no library")
        run = self.track(environment=dict(self.environment, LD_LIBRARY_PATH=str(broken)))
        self.assertEqual(run.returncode, 3, run.stderr)
        self.assertRegex(run.stderr, r"^live:kinect: error: found no loadable library \(.*\), expected "
                                     r"libfreenect\.so\.0\.5\nhint: Debian's package libfreenect0\.5 has it\n$")
        for bad, says in ((["--send", "127.0.0.1:9"], "found a camera without a pose"),
                          (["--rate", "30"], "--rate"), (["--seconds", "x"], "--seconds"),
                          (["--as", "operator"], "--as"), (["--send", "nowhere"], "--send"),
                          (["--send", "-", "--json"], "--json")):
            run = self.track(*bad)
            self.assertEqual(run.returncode, 2, (bad, run.stderr))
            self.assertIn(says, run.stderr)
        run = subprocess.run([PROGRAM, "track", "live:webcam"], capture_output=True, text=True, env=self.environment)
        self.assertEqual(run.returncode, 2, run.stderr)


if __name__ == "__main__":
    if not FAKENECT:
        print("skipped: no fakenect, which libfreenect0.5 has")
        sys.exit(77)
    unittest.main(verbosity=1)
