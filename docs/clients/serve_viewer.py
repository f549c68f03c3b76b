#!/usr/bin/env python3
"""Example viewer of `abstand serve`: prints the nearest distance of every moment.

    abstand serve data/scenes/hug_boxing.yaml
    python3 docs/clients/serve_viewer.py

Only the standard library. The frames are those of docs/serve.md.
"""
import argparse
import math
import select
import socket
import struct
import time

HEADER = struct.Struct("<4sHHIIQII")  # magic, version, type, sequence, left out, time in us, 0, bytes
WATCH, SCENE, MOMENT, ALIVE = 6, 7, 8, 9
RENEW = 1.0  # s; the server drops a viewer that is silent for 5 s
PERSON, GROUP = struct.Struct("<d"), struct.Struct("<II")
ROBOT = struct.Struct("<5dIIii")  # speed scale, age of input, since, value, limit, state, reason, pair, joint
JOINT = struct.Struct("<3d6fI")  # position, torque of contacts and of the reaction, axis
OBJECT = struct.Struct("<12d3d12f2dII")  # pose, centre of mass, velocity and wrench, margin, uncertainty, states
PAIR = struct.Struct("<3d6fihBB")  # distance, bound, margin, nearest points, contacts, group, paused, has force
FORCE = struct.Struct("<10d")


class Fields:
    def __init__(self, data):
        self.data, self.at = data, HEADER.size

    def take(self, form):
        values = form.unpack_from(self.data, self.at)
        self.at += form.size
        return values

    def number(self, code):
        return self.take(struct.Struct("<" + code))[0]

    def text(self):
        size = self.number("I")
        self.at += size
        return self.data[self.at - size:self.at].decode()

    def texts(self):
        return [self.text() for _ in range(self.number("I"))]


def scene_of(frame):
    f = Fields(frame)
    scene = {"server": f.number("Q"), "key": f.number("Q") | f.number("Q") << 64, "file": f.text(),
             "objects": f.texts(), "people": f.texts(), "groups": f.texts()}
    scene["robots"] = [(f.text(), f.number("I")) for _ in range(f.number("I"))]
    scene["pairs"] = [f.take(struct.Struct("<II")) for _ in range(f.number("I"))]
    return scene


def moment_of(frame, scene):
    f = Fields(frame)
    t, cycle_us, bad, late, lost, duplicates, torques_on = f.take(struct.Struct("<dd5I"))
    moment = {"t": t, "cycle_us": cycle_us, "bad": bad, "late": late, "lost": lost, "duplicates": duplicates,
              "torques_on": bool(torques_on)}
    moment["person_age"] = [f.take(PERSON)[0] for _ in scene["people"]]
    moment["robots"] = [f.take(ROBOT) for _ in scene["robots"]]
    moment["joints"] = [f.take(JOINT) for _ in range(sum(dof for _, dof in scene["robots"]))]
    moment["groups"] = [f.take(GROUP) for _ in scene["groups"]]
    moment["objects"] = [f.take(OBJECT) for _ in scene["objects"]]
    moment["pairs"] = []
    for _ in scene["pairs"]:
        pair = f.take(PAIR)
        moment["pairs"].append(pair + (f.take(FORCE) if pair[-1] else (0.0,) * 10))
    assert f.at == len(frame), "the frame has another size than its content"
    return moment


class Viewer:
    """Reads the stream of one server; `rate`: moments a second."""

    def __init__(self, host, port, rate=60.0):
        self.socket = socket.create_connection((host, port))
        self.rate, self.data, self.scene, self.renewed = rate, b"", None, 0.0
        self.alive = 0

    def watch(self):
        self.socket.sendall(HEADER.pack(b"ABST", 1, WATCH, 0, 0, 0, 0, HEADER.size + 8) + struct.pack("<d", self.rate))
        self.renewed = time.monotonic()

    def moment(self, seconds):
        """The next one with its header, or None when none came within `seconds`, or the server has closed."""
        until = time.monotonic() + seconds
        while True:
            size = HEADER.unpack_from(self.data)[-1] if len(self.data) >= HEADER.size else math.inf
            if len(self.data) >= size:
                frame, self.data = self.data[:size], self.data[size:]
                header = HEADER.unpack_from(frame)
                if header[2] == SCENE:
                    self.scene = scene_of(frame)
                elif header[2] == MOMENT:
                    return header, moment_of(frame, self.scene)
                else:
                    self.alive += 1
                continue
            if time.monotonic() - self.renewed > RENEW:
                self.watch()
            left = until - time.monotonic()
            if select.select([self.socket], [], [], min(max(left, 0.0), RENEW))[0]:
                received = self.socket.recv(1 << 20)
                if not received:
                    return None
                self.data += received
            elif left <= 0.0:
                return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=4780)
    parser.add_argument("--rate", type=float, default=2.0, help="moments a second")
    parser.add_argument("--seconds", type=float, default=10.0)
    args = parser.parse_args()
    viewer = Viewer(args.host, args.port, args.rate)
    until = time.monotonic() + args.seconds
    while time.monotonic() < until:
        try:
            found = viewer.moment(1.0)
        except ConnectionError:
            print("the server has ended")
            return
        if found is None:
            print("no moment for a second: nothing is known")
            continue
        moment = found[1]
        known = [(pair[0], i) for i, pair in enumerate(moment["pairs"]) if not math.isnan(pair[0]) and not pair[-12]]
        if not known:
            continue
        distance, i = min(known)
        a, b = (viewer.scene["objects"][o] for o in viewer.scene["pairs"][i])
        # 2: stale, 3: rejected; such a distance proves nothing.
        lost = any(moment["objects"][o][-2] > 1 for o in viewer.scene["pairs"][i])
        print(f"{moment['t']:9.3f} s  {a} - {b}: {distance:.4f} m" + (" (stale)" if lost else ""))


if __name__ == "__main__":
    main()
