"""CBOR by RFC 8949, as far as results have it: an independent reader, which says where it ends."""

import struct


class Number(str):
    """The decimal text of a number that is a byte string."""


BREAK = object()
FLOATS = {25: ">e", 26: ">f", 27: ">d"}
SIMPLE = {20: False, 21: True, 22: None, 31: BREAK}


def argument(data, at):
    info = data[at] & 31
    if info < 24:
        return info, at + 1
    size = 1 << (info - 24)
    return int.from_bytes(data[at + 1:at + 1 + size], "big"), at + 1 + size


def items(data, at, count):
    """`count` items, or all before a break where it is None; and where they end."""
    found = []
    while count is None or len(found) < count:
        value, at = item(data, at)
        if value is BREAK:
            break
        found.append(value)
    return found, at


def item(data, at=0):
    """(value, where it ends)"""
    major, info = data[at] >> 5, data[at] & 31
    if major == 7:
        if info in FLOATS:
            size = 1 << (info - 24)
            return struct.unpack(FLOATS[info], data[at + 1:at + 1 + size])[0], at + 1 + size
        return SIMPLE[info], at + 1
    count, at = (None, at + 1) if info == 31 else argument(data, at)
    if major in (0, 1):
        return (count if major == 0 else -1 - count), at
    if major == 2:
        return Number(data[at:at + count].decode()), at + count
    if major == 3:
        return data[at:at + count].decode(), at + count
    if major == 4:
        return items(data, at, count)
    assert major == 5, f"major type {major}"
    found, at = items(data, at, None if count is None else 2 * count)
    return dict(zip(found[::2], found[1::2])), at


def loads(data):
    value, end = item(data)
    assert end == len(data), f"{len(data) - end} bytes follow"
    return value
