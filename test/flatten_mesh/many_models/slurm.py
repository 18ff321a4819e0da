# Copyright (c) 2026 The Angle_based_flattening authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A cluster of Slurm whose only node is this machine. It needs neither root nor a configuration of the system."""

import os
import pwd
import shutil
import signal
import socket
import subprocess
import tempfile
from pathlib import Path

from folder import wait_until

# More processors and memory than there may be, as large machines have
CONFIGURATION = """
ClusterName=test
SlurmctldHost=localhost
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/linuxproc
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SlurmdParameters=config_overrides
MpiDefault=none
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
NodeName=localhost CPUs=8 RealMemory=65536
PartitionName=all Nodes=localhost Default=YES
"""


def free_ports(count):
    """Ports that nobody listens on"""
    probes = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [probe.getsockname()[1] for probe in probes]
    for probe in probes:
        probe.close()
    return ports


class Cluster:
    """Commands of Slurm reach it with its `environment`. At the end, all of its processes are ended."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp())
        self.configuration = self.folder / "slurm.conf"
        own = {name: value for name, value in os.environ.items() if not name.startswith(("SLURM_", "SBATCH_"))}
        self.environment = {**own, "SLURM_CONF": str(self.configuration)}
        self.daemons = []

    def __enter__(self):
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        user = pwd.getpwuid(os.getuid()).pw_name
        self.configuration.write_text(CONFIGURATION.format(ports=free_ports(2), user=user, folder=self.folder))
        try:
            for command in (["slurmctld", "-D"], ["slurmd", "-D", "-N", "localhost"]):
                with open(self.folder / f"{command[0]}.log", "wb") as log:
                    self.daemons.append(subprocess.Popen(command, env=self.environment, stdout=log, stderr=log))
            wait_until(self.is_ready)
        except BaseException:
            self.__exit__()
            raise
        return self

    def is_ready(self):
        assert all(daemon.poll() is None for daemon in self.daemons), self.logs()
        state = subprocess.run(["sinfo", "--noheader", "--format=%T"], env=self.environment, capture_output=True,
                               text=True, check=False)
        return state.stdout.strip() == "idle"

    def logs(self):
        return "\n".join(file.read_text() for file in self.folder.glob("*.log"))

    def processes(self):
        """Those of the daemons, and of jobs, which daemons do not take with them"""
        mark, found = f"SLURM_CONF={self.configuration}".encode(), []
        for file in Path("/proc").glob("[0-9]*/environ"):
            try:
                if mark in file.read_bytes().split(b"\0"):
                    found.append(int(file.parent.name))
            except OSError:  # has ended, or is not ours
                pass
        return found

    def end_processes(self):
        """Whether there was none. What is ended may just have started another."""
        processes = self.processes()
        for process in processes:
            try:
                os.kill(process, signal.SIGKILL)
            except ProcessLookupError:
                pass
        return not processes

    def __exit__(self, *_):
        wait_until(self.end_processes)
        for daemon in self.daemons:
            daemon.wait()
        shutil.rmtree(self.folder)
