#!/usr/bin/env python3
"""Receives the bodies that Abrazo sends as VMC, one port for each, and says where they are.

    abrazo live --library L.h5 --listen clip:leader.bvh --send vmc://127.0.0.1:39540 --send-user vmc://127.0.0.1:39550
    examples/receive/receive.py 39540 39550 [--seconds 5] [--json]

A start for a receiver of one's own: `messages` reads OSC, `Body` puts a frame together, `Body.places` gives the places of
the bones. Needs Python 3.9 and nothing else.
"""
import argparse
import json
import math
import select
import socket
import struct
import sys
import time

# Unity's humanoid without fingers, eyes and jaw. A bone's place and turn are relative to the next bone above it that is sent.
PARENT = {
    "Hips": None, "Spine": "Hips", "Chest": "Spine", "UpperChest": "Chest", "Neck": "UpperChest", "Head": "Neck",
    "LeftShoulder": "UpperChest", "LeftUpperArm": "LeftShoulder", "LeftLowerArm": "LeftUpperArm", "LeftHand": "LeftLowerArm",
    "RightShoulder": "UpperChest", "RightUpperArm": "RightShoulder", "RightLowerArm": "RightUpperArm",
    "RightHand": "RightLowerArm", "LeftUpperLeg": "Hips", "LeftLowerLeg": "LeftUpperLeg", "LeftFoot": "LeftLowerLeg",
    "LeftToes": "LeftFoot", "RightUpperLeg": "Hips", "RightLowerLeg": "RightUpperLeg", "RightFoot": "RightLowerLeg",
    "RightToes": "RightFoot"}


def padded_text(packet, at):
    end = packet.index(b"\0", at)
    return packet[at:end].decode(), at + (end - at + 4) // 4 * 4


def messages(packet):
    """The OSC messages of a packet as (address, arguments), those of bundles too. Raises ValueError for other packets."""
    if packet.startswith(b"#bundle\0"):
        at = 16  # behind the time tag
        while at < len(packet):
            (size,) = struct.unpack_from(">i", packet, at)
            if size <= 0 or at + 4 + size > len(packet):
                raise ValueError("a bundle is cut off")
            yield from messages(packet[at + 4:at + 4 + size])
            at += 4 + size
        return
    address, at = padded_text(packet, 0)
    kinds, at = padded_text(packet, at)
    arguments = []
    for kind in kinds[1:]:
        if kind == "s":
            value, at = padded_text(packet, at)
        elif kind in "if":
            (value,) = struct.unpack_from(">" + kind, packet, at)
            at += 4
        else:
            raise ValueError(f"an argument of the kind {kind!r}, which VMC does not have")
        arguments.append(value)
    yield address, arguments


def product(a, b):
    """Of quaternions (x, y, z, w)."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


def turned(q, v):
    x, y, z, w = q
    return product(product(q, (*v, 0.0)), (-x, -y, -z, w))[:3]


class Body:
    """One body of one port, in Unity's space: metres, Y up, left-handed (X to the right, Z forward)."""

    def __init__(self):
        self.root = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0))
        self.bones = {}
        self.is_tracked = True

    def take(self, packet):
        """Takes a packet. True when it ended a frame: T comes last, once a frame."""
        is_whole = False
        for address, values in messages(packet):
            if address == "/VMC/Ext/Root/Pos":
                self.root = (tuple(values[1:4]), tuple(values[4:8]))
            elif address == "/VMC/Ext/Bone/Pos" and values[0] in PARENT:
                self.bones[values[0]] = (tuple(values[1:4]), tuple(values[4:8]))
            elif address == "/VMC/Ext/OK" and len(values) > 3:
                self.is_tracked = values[3] == 1
            elif address == "/VMC/Ext/T":
                is_whole = True
        return is_whole and "Hips" in self.bones

    def places(self):
        """Bone -> place in the world [m]."""
        world = {None: self.root}
        for name, parent in PARENT.items():
            while parent is not None and parent not in self.bones:
                parent = PARENT[parent]
            if name not in self.bones:
                continue
            (place, turn), (offset, own) = world[parent], self.bones[name]
            world[name] = (tuple(p + o for p, o in zip(place, turned(turn, offset))), product(turn, own))
        del world[None]
        return {name: place for name, (place, _) in world.items()}

    def heading_deg(self):
        x, _, z = turned(product(self.root[1], self.bones["Hips"][1]), (0.0, 0.0, 1.0))
        return math.degrees(math.atan2(x, z))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("ports", type=int, nargs="+", help="one for each body")
    parser.add_argument("--seconds", type=float, default=float("inf"), help="ends after that time")
    parser.add_argument("--json", action="store_true", help="a line of JSON for every frame")
    arguments = parser.parse_args()
    bodies = {}
    for port in arguments.ports:
        listening = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            listening.bind(("127.0.0.1", port))
        except OSError as failure:
            sys.exit(f"receive: port {port} cannot be opened: {failure.strerror}; close the program that has it")
        bodies[listening] = Body()
    end = time.monotonic() + arguments.seconds
    told = 0.0
    while (left := end - time.monotonic()) > 0:
        for listening in select.select(list(bodies), [], [], min(left, 1))[0]:
            body, port = bodies[listening], listening.getsockname()[1]
            try:
                is_whole = body.take(listening.recv(65536))
            except (ValueError, IndexError, struct.error) as failure:
                print(f"receive: port {port}: a packet was left out: {failure}", file=sys.stderr)
                continue
            if not is_whole:
                continue
            places = body.places()
            if arguments.json:
                print(json.dumps({"port": port, "hips": places["Hips"], "head": places["Head"],
                                  "heading_deg": body.heading_deg(), "bones": len(places)}), flush=True)
            elif time.monotonic() - told > 0.2:
                told = time.monotonic()
                print(f"{port}: hips at {places['Hips'][0]:6.2f} {places['Hips'][2]:6.2f} m, "
                      f"heading {body.heading_deg():6.1f} deg", flush=True)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        pass
