# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A computation in a thread of its own that tells its progress and can be cancelled. Nothing here needs Blender."""

from __future__ import annotations

import threading
from typing import Any, Callable, Optional

Progress = Callable[[str, float], bool]


class Job:
    """Runs work(progress). The work gives up when progress() returns False."""

    def __init__(self, work: Callable[[Progress], Any]):
        self.work = work
        self.stage = ""
        self.share = 0.0
        self.result: Any = None
        self.error: Optional[BaseException] = None
        self._cancelled = threading.Event()
        self._thread: Optional[threading.Thread] = None

    def start(self) -> None:
        """Begins in a thread, which a program that ends does not wait for."""
        self._thread = threading.Thread(target=self.run, daemon=True)
        self._thread.start()

    def run(self) -> None:
        """Does the work in the calling thread, and keeps what it returns or raises."""
        try:
            self.result = self.work(self.progress)
        except BaseException as error:  # also KeyboardInterrupt: it is told where the job is read
            self.error = error

    def progress(self, stage: str, share: float) -> bool:
        self.stage, self.share = stage, share
        return not self._cancelled.is_set()

    def cancel(self) -> None:
        self._cancelled.set()

    @property
    def is_cancelled(self) -> bool:
        return self._cancelled.is_set()

    @property
    def is_done(self) -> bool:
        return self._thread is None or not self._thread.is_alive()

    def status(self) -> str:
        """What the status bar says."""
        stage = self.stage.lower().replace("_", " ") or "begin"
        return f"{stage}, {100 * self.share:.0f} % (Esc to cancel)"


def part_of(progress: Progress, k: int, number: int) -> Progress:
    """The progress of the k-th of several parts of the work."""
    return lambda stage, share: progress(stage, (k + share) / number)
