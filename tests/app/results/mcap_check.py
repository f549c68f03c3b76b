"""mcap_check.py FILE.mcap FILE.csv [EVENTS.json]: fails unless the messages of `abstand export --mcap` are the rows of `--csv`.

The events are those of `abstand events --json`. A byte that is changed anywhere has to be noticed. Where the Python package
`mcap` is installed, it has to read the same messages."""
import csv
import json
import math
import sys

import mcap_reader

# What Foxglove knows in a JSON schema of a topic.
TYPES = {"number": (float, int), "string": (str,), "boolean": (bool,)}
NUMBERS = ("distance", "bound", "uncertainty", "clearance", "robot_speed", "person_speed")
FLIPS = 60


def check(condition, what):
    if not condition:
        sys.exit(f"mcap_check: {what}")


def check_schema(schema, message, names):
    for name in schema["required"]:
        check(name in message, f"{name} is missing in {message}")
    for name, value in message.items():
        check(name in schema["properties"], f"{name} is not in the schema")
        check(isinstance(value, TYPES[schema["properties"][name]["type"]]), f"{name} is {value!r}")
        names.add(name)


def decoded(file):
    """Messages by topic: [(log_time, object)]."""
    schemas = {}
    for number, schema in file.schemas.items():
        check(schema.encoding == "jsonschema", "a schema is no JSON schema")
        schemas[number] = json.loads(schema.data)
        check(schemas[number]["type"] == "object", "a schema is not one of an object")
        for field in schemas[number]["properties"].values():
            check(field["type"] in TYPES, f"a field of type {field['type']}, which Foxglove does not read")
    topics, names, last, sequence = {c.topic: [] for c in file.channels.values()}, set(), 0, {}
    check(len(topics) == len(file.channels), "two channels have one topic")
    for m in file.messages:
        channel = file.channels[m.channel_id]
        check(channel.message_encoding == "json", "a message is no JSON")
        check(m.log_time >= last and m.publish_time == m.log_time, "the messages are not in order of time")
        check(m.sequence == sequence.get(m.channel_id, 0), "a message is missing in its topic")
        last, sequence[m.channel_id] = m.log_time, m.sequence + 1
        message = json.loads(m.data)
        check_schema(schemas[channel.schema_id], message, names)
        topics[channel.topic].append((m.log_time, message))
    return topics, names


def check_rows(file, topics, path, origin):
    by_name = {(c.metadata["recording"], c.metadata["part"]): c.topic for c in file.channels.values() if "part" in c.metadata}
    taken = dict.fromkeys(by_name.values(), 0)
    rows = unseen = 0
    for row in csv.DictReader(open(path, encoding="utf-8", newline="")):
        topic = by_name[row["recording"], row["part"]]
        log_time, message = topics[topic][taken[topic]]
        taken[topic] += 1
        rows += 1
        check(message["t"] == float(row["t"]) and message["link"] == row["link"], f"{row} is {message}")
        # Half a nanosecond may be rounded either way.
        check(abs(log_time - (float(row["t"]) - origin) * 1e9) <= 0.5 + 1e-6, f"{row['t']} s at {log_time} ns")
        for name in NUMBERS:
            value = float(row[name])
            if math.isfinite(value):
                check(message.get(name) == value, f"{name} of {row} is {message.get(name)}")
            else:
                check(name not in message, f"{name} is {value}, and there is one in {message}")
        check(message["seen"] == math.isfinite(float(row["clearance"])), f"seen of {row}")
        unseen += not message["seen"]
    for topic, count in taken.items():
        check(count == len(topics[topic]), f"{topic} has more messages than rows")
    return rows, unseen


def check_events(topics, path):
    answer = json.load(open(path, encoding="utf-8"))
    # The terms of the protective distance are in the JSON alone.
    left_out = ("t0", "separation")
    expected = sorted(({"t": e["t0"], **{k: v for k, v in e.items() if k not in left_out and v is not None}}
                       for e in answer["events"]), key=json.dumps)
    found = sorted((message for _, message in topics["/events"]), key=json.dumps)
    check(sorted(map(sorted_text, expected)) == sorted(map(sorted_text, found)), "other events than those of `abstand events`")
    check(len(topics["/approaches"]) == len(answer["approaches"]), "other approaches")
    for (_, a), b in zip(sorted(topics["/approaches"], key=lambda m: (m[1]["t"], m[1]["part"], m[1]["recording"])),
                         sorted(answer["approaches"], key=lambda b: (b["t"], b["part"], b["recording"]))):
        for name in ("t", "recording", "part", "link", "distance", "clearance", "closing_speed", "robot_speed", "person_speed",
                     "robot_mass"):
            check(a.get(name) == b[name], f"{name} of {b} is {a.get(name)}")
    return len(found)


def sorted_text(value):
    return json.dumps(value, sort_keys=True)


def check_damage(data):
    for i in range(FLIPS):
        at = i * (len(data) - 1) // (FLIPS - 1)
        changed = bytearray(data)
        changed[at] ^= 1 << (i % 8)
        try:
            mcap_reader.read(bytes(changed))
        except mcap_reader.Damaged:
            continue
        sys.exit(f"mcap_check: a change of byte {at} is not noticed")


def check_package(path, file):
    try:
        from mcap.reader import make_reader
    except ImportError:
        return
    with open(path, "rb") as stream:
        found = [(c.topic, m.log_time, m.data) for _, c, m in make_reader(stream, validate_crcs=True).iter_messages()]
    expected = [(file.channels[m.channel_id].topic, m.log_time, m.data) for m in file.messages]
    check(sorted(found) == sorted(expected), "the package `mcap` reads other messages")


def main():
    data = open(sys.argv[1], "rb").read()
    file = mcap_reader.read(data)
    check(file.library.startswith("abstand "), "the library is not named")
    topics, names = decoded(file)
    options = file.metadata["abstand"]
    rows, unseen = check_rows(file, topics, sys.argv[2], float(options["time_origin"]))
    events = check_events(topics, sys.argv[3]) if len(sys.argv) > 3 else 0
    check(("/events" in topics) == (len(sys.argv) > 3), "events without a margin, or none with one")
    check_damage(data)
    check_package(sys.argv[1], file)
    print(json.dumps({"rows": rows, "unseen": unseen, "events": events, "approaches": len(topics["/approaches"]),
                      "chunks": len(file.chunks), "topics": sorted(topics), "fields": sorted(names)}))


if __name__ == "__main__":
    main()
