# tests/farm/slurm_node.py: Slurm with one node, this machine, for as long as a test needs it.
import os
import pathlib
import shutil
import socket
import subprocess
import time

NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "sinfo", "scontrol")

CONFIGURATION = """ClusterName=sinew
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
SlurmctldPort={controller}
SlurmdPort={node}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} RealMemory={memory} State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def why_not():
    """Why Slurm cannot be started here, or None."""
    path = os.environ["PATH"] + ":/usr/sbin:/sbin"
    missing = [program for program in NEEDED if shutil.which(program, path=path) is None]
    if missing:
        return "Slurm is not installed: no " + ", ".join(missing)
    if os.geteuid() != 0:
        return "Slurm's daemons start as root alone"
    return None


def memory_of_machine():
    """Megabytes."""
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // (1 << 20)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Node:
    """A context: sbatch and its like work with `environment`."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.environment = dict(os.environ, SLURM_CONF=str(self.folder / "slurm.conf"),
                                PATH=os.environ["PATH"] + ":/usr/sbin:/sbin")

    def run(self, *words, check=True, **options):
        return subprocess.run(words, env=self.environment, text=True, capture_output=True, check=check, timeout=120,
                              **options)

    def __enter__(self):
        host = socket.gethostname().split(".")[0]
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        self.configuration = self.folder / "slurm.conf"
        self.configuration.write_text(CONFIGURATION.format(host=host, folder=self.folder, controller=free_port(),
                                                           node=free_port(), cores=os.cpu_count(),
                                                           memory=memory_of_machine()))
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o400)
        at = "--%s=" + str(self.folder / "munge.%s")
        try:
            self.run("munged", "--force", "--key-file=" + str(key), at % ("socket", "socket"),
                     at % ("pid-file", "pid"), at % ("log-file", "log"), at % ("seed-file", "seed"))
            self.run("slurmctld", "-c")
            self.run("slurmd")
            self.wait("the node to be idle", lambda: "idle" in self.run("sinfo", "-h", check=False).stdout)
        except BaseException:
            self.__exit__()
            raise
        return self

    def wait(self, what, holds):
        end = time.monotonic() + 60
        while not holds():
            if time.monotonic() > end:
                logs = "".join(log.read_text()[-2000:] for log in self.folder.glob("*.log"))
                raise RuntimeError("waited in vain for " + what + "\n" + logs)
            time.sleep(0.2)

    def __exit__(self, *_):
        """Ends the daemons and waits for them: they write into the folder until then."""
        for name in ("slurmd", "slurmctld", "munge"):
            file = self.folder / (name + ".pid")
            number = file.read_text().strip() if file.exists() else ""
            if not number:
                continue
            subprocess.run(["kill", number], check=False)
            end = time.monotonic() + 30
            while pathlib.Path("/proc", number).exists() and time.monotonic() < end:
                time.sleep(0.1)
            if pathlib.Path("/proc", number).exists():
                subprocess.run(["kill", "-9", number], check=False)
