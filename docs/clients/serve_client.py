#!/usr/bin/env python3
"""Example client of `abstand serve`: sends joint values at a fixed rate and measures the round trip.

    abstand serve data/scenes/hug_boxing.yaml
    python3 docs/clients/serve_client.py --joints 14 --mechanisms 2 --people 1

Only the standard library. The packets are those of docs/serve.md; `abstand serve SCENE --layout` prints them
for one scene.
"""
import argparse
import math
import select
import socket
import struct
import time

HEADER = struct.Struct("<4sHHIIQII")  # magic, version, type, sequence, index, time in us, flags, bytes
JOINTS, SKELETON, STATE = 1, 2, 3
ALL = 0xFFFFFFFF
RESET, UNASKED = 1, 2
SERVER = struct.Struct("<QdIIII")  # time in us, last cycle in us, bad, late, lost, duplicates
ROBOT = struct.Struct("<dddII")  # speed scale, age of its input, state since, state, reason
STATES = ["running", "slowing", "protective stop", "emergency stop", "waiting for reset"]

# A person who stands upright: pelvis, spine, thorax, neck, head, head top, then left and right arm (shoulder,
# elbow, wrist, hand) and left and right leg (hip, knee, ankle, toe). Metres, z up.
STANDING = [(0, 0, 0.95), (0, 0, 1.10), (0, 0, 1.30), (0, 0, 1.48), (0, 0, 1.60), (0, 0, 1.75)]
for side in (1, -1):
    STANDING += [(0, 0.19 * side, 1.42), (0, 0.21 * side, 1.14), (0.05, 0.21 * side, 0.90), (0.05, 0.21 * side, 0.80)]
for side in (1, -1):
    STANDING += [(0, 0.09 * side, 0.92), (0, 0.09 * side, 0.50), (0, 0.09 * side, 0.08), (0.18, 0.09 * side, 0.02)]


class Client:
    """Sends packets and reads answers. One socket; every kind of packet has sequence numbers of its own."""

    def __init__(self, host, port):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        # Answers wait here while this program does not run; the system gives what it allows.
        self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        self.socket.connect((host, port))
        self.sequence = {}

    def send(self, kind, index, body, flags=0):
        """Gives the sequence number."""
        sequence = self.sequence.get((kind, index), 0)
        self.sequence[kind, index] = (sequence + 1) & 0xFFFFFFFF
        stamp = time.perf_counter_ns() // 1000
        size = HEADER.size + len(body)
        self.socket.send(HEADER.pack(b"ABST", 1, kind, sequence, index, stamp, flags, size) + body)
        return sequence

    def joints(self, q, index=ALL, reset=False):
        return self.send(JOINTS, index, struct.pack("<%dd" % len(q), *q), RESET if reset else 0)

    def skeleton(self, person, points):
        """`points`: x, y, z of all 22 joints, or None for one that is not seen."""
        body = b"".join(struct.pack("<3d", *(p or (0, 0, 0))) for p in points)
        states = bytes(2 if p else 0 for p in points)
        return self.send(SKELETON, person, body + states + bytes(-len(states) % 8))

    def receive(self, seconds):
        """The next answer, or None when none came within `seconds`."""
        if not select.select([self.socket], [], [], max(0.0, seconds))[0]:
            return None
        return self.socket.recv(65536)


def sequence_of(answer):
    """Of the packet that is answered; None for what answers no packet."""
    magic, _, kind, sequence, _, _, flags, _ = HEADER.unpack_from(answer)
    return sequence if magic == b"ABST" and kind == STATE and not flags & UNASKED else None


def server_of(answer):
    keys = ("time_us", "cycle_us", "bad", "late", "lost", "duplicates")
    return dict(zip(keys, SERVER.unpack_from(answer, HEADER.size)))


def robot_of(answer, mechanism, people):
    at = HEADER.size + SERVER.size + 8 * people + ROBOT.size * mechanism
    scale, age, since, state, reason = ROBOT.unpack_from(answer, at)
    return {"speed_scale": scale, "age": age, "since": since, "state": STATES[state], "reason": reason}


def measure(client, joints, people, seconds, rate, place, on_answer=lambda answer: None):
    """Swings all joints gently and sends skeletons every 10 ms. Gives the round trips (s) and how many packets
    had no answer."""
    standing = [(x + place[0], y + place[1], z + place[2]) for x, y, z in STANDING]
    waiting, trips = {}, []

    def take(answer):
        on_answer(answer)
        sent = waiting.pop(sequence_of(answer), None)
        if sent is not None:
            trips.append(time.perf_counter() - sent)

    begin = time.perf_counter()
    skeletons = max(1, round(rate / 100))
    for i in range(int(seconds * rate)):
        if i % skeletons == 0:
            for person in range(people):
                client.skeleton(person, standing)
        q = [0.2 * math.sin(i / rate + j) for j in range(joints)]
        sent = time.perf_counter()
        waiting[client.joints(q, reset=i == 0)] = sent
        while True:
            answer = client.receive(begin + (i + 1) / rate - time.perf_counter())
            if answer is None:
                break
            take(answer)
    while waiting:
        answer = client.receive(0.5)
        if answer is None:
            break
        take(answer)
    return trips, len(waiting)


def share(values, part):
    return sorted(values)[min(len(values) - 1, int(part * len(values)))] if values else math.nan


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=4780)
    parser.add_argument("--joints", type=int, required=True, help="of all mechanisms together")
    parser.add_argument("--mechanisms", type=int, default=1)
    parser.add_argument("--people", type=int, default=0)
    parser.add_argument("--place", type=float, nargs=3, default=(1.5, 0.0, 0.0), help="where the person stands, m")
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--rate", type=float, default=1000.0, help="packets a second")
    args = parser.parse_args()
    last = []
    trips, unanswered = measure(Client(args.host, args.port), args.joints, args.people, args.seconds, args.rate,
                                args.place, lambda answer: last.__setitem__(slice(None), [answer]))
    print("%d answered, %d unanswered; round trip: median %.0f us, p99 %.0f us, max %.0f us" % (
        len(trips), unanswered, 1e6 * share(trips, 0.5), 1e6 * share(trips, 0.99), 1e6 * share(trips, 1.0)))
    for mechanism in range(args.mechanisms if last else 0):
        print("mechanism %d: %s" % (mechanism, robot_of(last[0], mechanism, args.people)))


if __name__ == "__main__":
    main()
