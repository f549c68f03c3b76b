"""A reader of MCAP files that follows the specification (https://mcap.dev/spec) and shares nothing with the writer.

read(bytes) gives a File, or raises Damaged: magic, lengths of records, checksums, message and chunk indices, summary offsets and
statistics all have to agree with the messages."""
import collections
import ctypes
import ctypes.util
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = range(11, 16)

Schema = collections.namedtuple("Schema", "id name encoding data")
Channel = collections.namedtuple("Channel", "id schema_id topic message_encoding metadata")
Message = collections.namedtuple("Message", "channel_id sequence log_time publish_time data")
File = collections.namedtuple("File", "library schemas channels messages metadata chunks")


class Damaged(Exception):
    pass


def expect(condition, what):
    if not condition:
        raise Damaged(what)


class Fields:
    """Reads the fields of a record one after the other."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, size):
        expect(self.at + size <= len(self.data), "a record ends within a number")
        value = int.from_bytes(self.data[self.at:self.at + size], "little")
        self.at += size
        return value

    def numbers(self, *sizes):
        return [self.number(size) for size in sizes]

    def bytes(self, size):
        expect(self.at + size <= len(self.data), "a record ends within its bytes")
        value = self.data[self.at:self.at + size]
        self.at += size
        return value

    def text(self):
        try:
            return self.bytes(self.number(4)).decode("utf-8")
        except UnicodeDecodeError as error:
            raise Damaged("a text is not UTF-8") from error

    def entries(self, read):
        """Of an array or a map: what `read` gives of each entry."""
        inner, found = Fields(self.bytes(self.number(4))), []
        while inner.at < len(inner.data):
            found.append(read(inner))
        return found

    def map(self, read):
        found = self.entries(read)
        expect(len(dict(found)) == len(found), "a map has a key twice")
        return dict(found)

    def end(self, what):
        expect(self.at == len(self.data), f"{what} is longer than its fields")


def text_map(fields):
    return fields.map(lambda f: (f.text(), f.text()))


def records(data, begin, end):
    """(kind, content, begin, end) of each."""
    while begin < end:
        expect(begin + 9 <= end, "a record has no length")
        kind, length = struct.unpack_from("<BQ", data, begin)
        content = begin + 9
        expect(content + length <= end, "a record is longer than its section")
        yield kind, data[content:content + length], begin, content + length
        begin = content + length


def decompress(name, data, size):
    if name == "":
        return data
    expect(name == "zstd", f"unknown compression {name!r}")
    library = ctypes.CDLL(ctypes.util.find_library("zstd") or "libzstd.so.1")
    library.ZSTD_decompress.restype = ctypes.c_size_t
    library.ZSTD_decompress.argtypes = [ctypes.c_char_p, ctypes.c_size_t, ctypes.c_char_p, ctypes.c_size_t]
    expect(size < 1 << 30, "a chunk is too large")
    out = ctypes.create_string_buffer(max(1, size))
    expect(library.ZSTD_decompress(out, size, data, len(data)) == size, "a chunk cannot be decompressed")
    return out.raw[:size]


def schema(content):
    f = Fields(content)
    value = Schema(f.number(2), f.text(), f.text(), f.bytes(f.number(4)))
    f.end("a schema")
    expect(value.id != 0, "a schema has the number 0")
    return value


def channel(content):
    f = Fields(content)
    value = Channel(f.number(2), f.number(2), f.text(), f.text(), text_map(f))
    f.end("a channel")
    return value


class Reader:
    def __init__(self, data):
        self.data = data
        self.file = File("", {}, {}, [], {}, [])
        self.library = ""
        self.metadata_places = {}

    def read(self):
        data = self.data
        expect(data[:8] == MAGIC and data[-8:] == MAGIC and len(data) >= 45, "no magic at both ends")
        footer_at = len(data) - 8 - 29
        kind, length = struct.unpack_from("<BQ", data, footer_at)
        expect(kind == FOOTER and length == 20, "no footer before the last magic")
        summary, offsets, crc = struct.unpack_from("<QQI", data, footer_at + 9)
        expect(8 < summary <= offsets <= footer_at, "the footer points out of the file")
        expect(crc != 0 and crc == zlib.crc32(data[summary:footer_at + 25]), "the summary's checksum differs")
        self.read_data(summary)
        self.read_summary(summary, offsets)
        self.read_offsets(summary, offsets, footer_at)
        return self.file._replace(library=self.library)

    def add(self, known, value):
        expect(known.setdefault(value.id, value) == value, "two records of one number differ")

    def read_data(self, end):
        pending = None  # the chunk whose message indices follow
        ended = False
        for number, (kind, content, begin, after) in enumerate(records(self.data, 8, end)):
            expect(not ended, "records behind the end of the data")
            expect((kind == HEADER) == (number == 0), "the header is not the first record")
            if kind != MESSAGE_INDEX and pending:
                self.finish_chunk(pending)
                pending = None
            f = Fields(content)
            if kind == HEADER:
                expect(f.text() == "", "an unknown profile")
                self.library = f.text()
                f.end("the header")
            elif kind == SCHEMA:
                self.add(self.file.schemas, schema(content))
            elif kind == CHANNEL:
                self.add_channel(content)
            elif kind == METADATA:
                name = f.text()
                self.file.metadata[name] = text_map(f)
                f.end("metadata")
                self.metadata_places[name] = (begin, after - begin)
            elif kind == CHUNK:
                pending = self.chunk(content, begin, after)
            elif kind == MESSAGE_INDEX:
                expect(pending is not None, "a message index without a chunk")
                self.message_index(pending, f, begin, after)
            elif kind == DATA_END:
                crc = f.number(4)
                f.end("the end of the data")
                expect(crc != 0 and crc == zlib.crc32(self.data[:begin]), "the data's checksum differs")
                ended = True
            else:
                raise Damaged(f"a record of kind {kind} among the data")
        expect(ended, "the data does not end")

    def add_channel(self, content):
        value = channel(content)
        expect(value.schema_id in self.file.schemas, "a channel before its schema")
        self.add(self.file.channels, value)

    def chunk(self, content, begin, after):
        f = Fields(content)
        first, last, size, crc = f.numbers(8, 8, 8, 4)
        compression = f.text()
        packed = f.bytes(f.number(8))
        f.end("a chunk")
        plain = decompress(compression, packed, size)
        expect(crc != 0 and crc == zlib.crc32(plain), "a chunk's checksum differs")
        expected = collections.defaultdict(list)
        times = []
        for kind, body, at, _ in records(plain, 0, len(plain)):
            if kind == CHANNEL:
                self.add_channel(body)
                continue
            expect(kind == MESSAGE, "a chunk holds more than messages")
            m = Fields(body)
            message = Message(*m.numbers(2, 4, 8, 8), bytes(m.bytes(len(body) - 22)))
            expect(message.channel_id in self.file.channels, "a message before its channel")
            self.file.messages.append(message)
            expected[message.channel_id].append((message.log_time, at))
            times.append(message.log_time)
        expect(times and (min(times), max(times)) == (first, last), "a chunk's times are not those of its messages")
        return {"begin": begin, "length": after - begin, "first": first, "last": last, "compression": compression,
                "packed": len(packed), "size": size, "expected": dict(expected), "index": {}, "offsets": {}, "index_length": 0}

    def message_index(self, chunk, f, begin, after):
        number = f.number(2)
        expect(number not in chunk["index"], "a channel has two message indices in a chunk")
        chunk["index"][number] = f.entries(lambda e: (e.number(8), e.number(8)))
        f.end("a message index")
        chunk["offsets"][number] = begin
        chunk["index_length"] += after - begin

    def finish_chunk(self, chunk):
        expect(chunk["index"] == chunk["expected"], "the message indices are not those of the chunk")
        self.file.chunks.append(chunk)

    def read_summary(self, begin, end):
        schemas, channels, chunks, metadata, statistics, kinds = {}, {}, [], {}, None, []
        for kind, content, at, after in records(self.data, begin, end):
            if not kinds or kinds[-1][0] != kind:
                kinds.append([kind, at, after])
            kinds[-1][2] = after
            f = Fields(content)
            if kind == SCHEMA:
                self.add(schemas, schema(content))
            elif kind == CHANNEL:
                self.add(channels, channel(content))
            elif kind == CHUNK_INDEX:
                value = dict(zip(("first", "last", "begin", "length"), f.numbers(8, 8, 8, 8)))
                value["offsets"] = f.map(lambda e: (e.number(2), e.number(8)))
                value["index_length"] = f.number(8)
                value["compression"] = f.text()
                value["packed"], value["size"] = f.numbers(8, 8)
                f.end("a chunk index")
                chunks.append(value)
            elif kind == METADATA_INDEX:
                place = tuple(f.numbers(8, 8))
                metadata[f.text()] = place
                f.end("a metadata index")
            elif kind == STATISTICS:
                expect(statistics is None, "two statistics")
                statistics = (f.numbers(8, 2, 4, 4, 4, 4, 8, 8), f.map(lambda e: (e.number(2), e.number(8))))
                f.end("the statistics")
            else:
                raise Damaged(f"a record of kind {kind} in the summary")
        file = self.file
        expect(schemas == file.schemas and channels == file.channels, "the summary has other schemas or channels")
        expect(metadata == self.metadata_places, "the metadata indices differ")
        shared = ("first", "last", "begin", "length", "offsets", "index_length", "compression", "packed", "size")
        expect(chunks == [{key: c[key] for key in shared} for c in file.chunks], "the chunk indices differ")
        times = [m.log_time for m in file.messages] or [0]
        counts = collections.Counter(m.channel_id for m in file.messages)
        expect(statistics == ([len(file.messages), len(schemas), len(channels), 0, len(metadata), len(chunks), min(times),
                               max(times)], dict(counts)), "the statistics differ")
        expect(len({kind for kind, _, _ in kinds}) == len(kinds), "the summary is not grouped")
        self.groups = {kind: (at, after - at) for kind, at, after in kinds}

    def read_offsets(self, summary, begin, end):
        groups = {}
        for kind, content, _, _ in records(self.data, begin, end):
            expect(kind == SUMMARY_OFFSET, "other records among the summary offsets")
            f = Fields(content)
            group, at, length = f.numbers(1, 8, 8)
            f.end("a summary offset")
            groups[group] = (at, length)
        expect(groups == self.groups, "the summary offsets differ")


def read(data):
    return Reader(data).read()
