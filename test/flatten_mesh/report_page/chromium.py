# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a display, driven by the WebDriver protocol"""

import base64
import json
import shutil
import socket
import subprocess
import time
import urllib.error
import urllib.request
from pathlib import Path

ARGUMENTS = ["--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
             "--disable-dev-shm-usage", "--hide-scrollbars", "--force-prefers-reduced-motion",
             "--force-color-profile=srgb"]

# A proxy for the network does not know this machine.
OPENER = urllib.request.build_opener(urllib.request.ProxyHandler({}))


def missing_programs() -> list[str]:
    """Those that are needed"""
    return [name for name in ("chromium", "chromedriver") if shutil.which(name) is None]


def free_port() -> int:
    """One that nobody listens on"""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Chromium:
    """A window of its own. Places are in pixels from its upper left."""

    def __init__(self, size: tuple[int, int], *arguments: str):
        port = free_port()
        self.address = f"http://127.0.0.1:{port}"
        # pylint: disable=consider-using-with
        self.driver = subprocess.Popen(["chromedriver", f"--port={port}"], stdout=subprocess.DEVNULL,
                                       stderr=subprocess.DEVNULL)
        try:
            self.wait_for_driver()
            options = {"binary": shutil.which("chromium"), "args": ARGUMENTS + list(arguments)}
            wishes = {"browserName": "chrome", "goog:loggingPrefs": {"browser": "ALL"},
                      "goog:chromeOptions": options}
            session = self.call("POST", "/session", {"capabilities": {"alwaysMatch": wishes}})["sessionId"]
            self.address += f"/session/{session}"
            self.resize(*size)
        except BaseException:
            self.driver.kill()
            raise

    def wait_for_driver(self) -> None:
        """Until it answers"""
        deadline = time.monotonic() + 60
        while True:
            try:
                self.call("GET", "/status")
                return
            except OSError:
                if time.monotonic() > deadline:
                    raise
                time.sleep(0.05)

    def call(self, method: str, path: str, body: dict | None = None):
        """The value of the driver's answer"""
        request = urllib.request.Request(
            self.address + path, method=method, headers={"Content-Type": "application/json"},
            data=None if body is None else json.dumps(body).encode())
        try:
            with OPENER.open(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def close(self) -> None:
        """Ends the browser and its driver."""
        try:
            self.call("DELETE", "")
        finally:
            self.driver.kill()
            self.driver.wait()

    def command(self, name: str, **parameters):
        """One of Chromium's own protocol"""
        return self.call("POST", "/goog/cdp/execute", {"cmd": name, "params": parameters})

    def resize(self, width: int, height: int) -> None:
        """What the page has, without what is around it"""
        self.command("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                     mobile=False)

    def open(self, page: Path) -> None:
        """Returns when it is loaded."""
        self.call("POST", "/url", {"url": page.as_uri()})

    def run(self, script: str, *arguments):
        """What the script returns; it may wait."""
        return self.call("POST", "/execute/sync", {"script": f"return (async () => {{ {script} }})();",
                                                   "args": list(arguments)})

    def rest(self) -> None:
        """Waits until all that was asked for is drawn."""
        self.run("for(let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);")

    def complaints(self) -> list[str]:
        """Warnings and errors on the console since the last call"""
        entries = self.call("POST", "/se/log", {"type": "browser"})
        return [entry["message"] for entry in entries if entry["level"] in ("WARNING", "SEVERE")]

    def perform(self, *sources: dict) -> None:
        """What mouse, fingers, wheel and keys do"""
        self.call("POST", "/actions", {"actions": list(sources)})
        self.rest()

    def mouse(self, *actions: dict) -> None:
        """See move(), and "pointerDown" and so on in the protocol"""
        self.perform({"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
                      "actions": list(actions)})

    def click(self, place: tuple[float, float]) -> None:
        """With the left button"""
        self.mouse(move(place), {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0})

    def press(self, key: str) -> None:
        """And lets it go. `key` is as in the protocol."""
        self.perform({"type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key},
                                                               {"type": "keyUp", "value": key}]})

    def touch(self, *fingers: list[tuple[float, float]]) -> None:
        """Each finger is put down at the first of its places and moves along them."""
        down, up = {"type": "pointerDown", "button": 0}, {"type": "pointerUp", "button": 0}
        self.perform(*({"type": "pointer", "id": f"finger {i}", "parameters": {"pointerType": "touch"},
                        "actions": [move(places[0]), down, *map(move, places[1:]), up]}
                       for i, places in enumerate(fingers)))

    def screenshot(self) -> bytes:
        """A PNG file"""
        return base64.b64decode(self.call("GET", "/screenshot"))


def move(place: tuple[float, float]) -> dict:
    """The movement of a pointer"""
    return {"type": "pointerMove", "x": round(place[0]), "y": round(place[1]), "duration": 0}
