# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures as PNG files of 8 bits per channel without interlacing: what browsers write"""

import struct
import zlib
from itertools import accumulate

Color = tuple[int, int, int]


def paeth(left: int, above: int, corner: int) -> int:
    """The neighbour that PNG predicts with"""
    guess = left + above - corner
    distances = abs(guess - left), abs(guess - above), abs(guess - corner)
    return (left, above, corner)[distances.index(min(distances))]


def unfiltered(kind: int, line: bytearray, above: bytearray, channels: int) -> bytearray:
    """A line of the picture from that of the file"""
    if kind == 1:
        for channel in range(channels):
            line[channel::channels] = bytes(accumulate(line[channel::channels], lambda a, b: (a + b) & 255))
    elif kind == 2:
        return bytearray((a + b) & 255 for a, b in zip(line, above))
    elif kind in (3, 4):
        for i, value in enumerate(line):
            left, corner = (line[i - channels], above[i - channels]) if i >= channels else (0, 0)
            line[i] = (value + ((left + above[i]) // 2 if kind == 3 else paeth(left, above[i], corner))) & 255
    return line


class Picture:
    """Its colours, at places in pixels from the upper left"""

    def __init__(self, file: bytes):
        assert file[:8] == b"\x89PNG\r\n\x1a\n"
        place, data = 8, b""
        while place < len(file):
            length, kind = struct.unpack(">I4s", file[place:place + 8])
            chunk = file[place + 8:place + 8 + length]
            if kind == b"IHDR":
                self.width, self.height, depth, colors, *_, interlaced = struct.unpack(">IIBBBBB", chunk)
                assert depth == 8 and colors in (2, 6) and not interlaced
                self.channels = {2: 3, 6: 4}[colors]
            elif kind == b"IDAT":
                data += chunk
            place += length + 12
        self.lines = self.decoded(zlib.decompress(data))

    def decoded(self, data: bytes) -> list[bytearray]:
        """Line by line"""
        stride = self.width * self.channels
        lines, above = [], bytearray(stride)
        for y in range(self.height):
            begin = y * (stride + 1)
            above = unfiltered(data[begin], bytearray(data[begin + 1:begin + 1 + stride]), above, self.channels)
            lines.append(above)
        return lines

    def __call__(self, place: tuple[float, float]) -> Color:
        begin = int(place[0]) * self.channels
        red, green, blue = self.lines[int(place[1])][begin:begin + 3]
        return red, green, blue
