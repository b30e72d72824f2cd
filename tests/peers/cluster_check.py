"""The pages of examples/cluster/ with the programs that they are for: a shard is killed, and the result is that of one process.

    cluster_check.py --abrazo PROGRAM --examples FOLDER --scheduler slurm|snakemake|parallel

Exit status 77 where the scheduler is not installed or does not start here.
"""
import argparse
import getpass
import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SHARDS = 4
ARGUMENTS = ("--manifest demo/manifest.json --x alpha=0:1:2 --y velocity-weight=0.05,0.2 "
             "--metric partner.mean_joint_error_m --report {}\n")
# Kills the program in its second shard, the first time.
WRAPPER = """#!/bin/bash
case "$*" in
*"--shard 2/"*)
  if mkdir "{folder}/killed" 2>/dev/null; then
    "{program}" "$@" &
    sleep 0.03
    kill -9 $!
    wait $!
    exit 137
  fi;;
esac
echo "$*" >> "{folder}/started"
exec "{program}" "$@"
"""


def figures(file):
    """What was evaluated, without what a clock measured."""
    points = json.loads(file.read_text())["points"]
    return {(p["x"], p["y"]): {name: value for name, value in p["figures"].items() if not name.startswith("solve_us")}
            for p in points}


def run(words, folder, environment, check=True, **more):
    done = subprocess.run([str(w) for w in words], cwd=folder, env=environment, capture_output=True, text=True, **more)
    if check and done.returncode != 0:
        sys.exit(f"{words[0]} failed: {done.stdout}{done.stderr}")
    return done


def with_snakemake(folder, environment):
    environment = {**environment, "HOME": str(folder), "XDG_CACHE_HOME": str(folder / "cache")}
    run(["snakemake", "--cores", "2", "--config", f"shards={SHARDS}"], folder, environment)


def with_parallel(folder, environment):
    run(["./sweep.parallel", "-j", "2"], folder, {**environment, "SHARDS": str(SHARDS), "HOME": str(folder)})


def free_port():
    with socket.socket() as it:
        it.bind(("127.0.0.1", 0))
        return it.getsockname()[1]


def with_slurm(folder, environment):
    """A controller and a node of our own, which end with the test."""
    host = socket.gethostname().split(".")[0]
    user = getpass.getuser()
    state = folder / "slurm"
    for name in ("state", "spool"):
        (state / name).mkdir(parents=True)
    conf = state / "slurm.conf"
    conf.write_text(f"""ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
MpiDefault=none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SwitchType=switch/none
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
StateSaveLocation={state}/state
SlurmdSpoolDir={state}/spool
SlurmctldPidFile={state}/slurmctld.pid
SlurmdPidFile={state}/slurmd.pid
SlurmctldLogFile={state}/slurmctld.log
SlurmdLogFile={state}/slurmd.log
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
""")
    environment = {**environment, "SLURM_CONF": str(conf)}
    daemons = [subprocess.Popen([shutil.which(name, path="/usr/sbin:/usr/bin"), "-D", *more], env=environment,
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
               for name, more in (("slurmctld", ["-f", conf]), ("slurmd", ["-f", conf, "-N", host]))]
    try:
        for _ in range(60):
            if "idle" in run(["sinfo", "-h", "-o", "%T"], folder, environment, check=False).stdout:
                break
            if any(daemon.poll() is not None for daemon in daemons):
                break
            time.sleep(0.5)
        else:
            time.sleep(0)
        if "idle" not in run(["sinfo", "-h", "-o", "%T"], folder, environment, check=False).stdout:
            print("slurm does not start here:", *(log.read_text()[-1500:] for log in state.glob("*.log")), sep="\n")
            sys.exit(77)

        def submit():
            run(["sbatch", "--wait", f"--array=1-{SHARDS}", "sweep.sbatch"], folder, environment, check=False, timeout=300)

        submit()
        merged = run(["abrazo", "sweep", "--merge", "--report", "sweep"], folder, environment, check=False)
        assert not (folder / "sweep" / "sweep.json").exists(), merged.stdout + merged.stderr
        submit()
        run(["abrazo", "sweep", "--quiet", "--merge", "--report", "sweep"], folder, environment)
    finally:
        for daemon in daemons:
            daemon.send_signal(signal.SIGTERM)
        for daemon in daemons:
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()


SCHEDULERS = {"snakemake": (with_snakemake, ["snakemake"]), "parallel": (with_parallel, ["parallel"]),
              "slurm": (with_slurm, ["sbatch", "slurmctld", "slurmd"])}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--abrazo", required=True)
    parser.add_argument("--examples", required=True)
    parser.add_argument("--scheduler", required=True, choices=SCHEDULERS)
    words = parser.parse_args()
    start, programs = SCHEDULERS[words.scheduler]
    path = os.pathsep.join([os.environ["PATH"], "/usr/sbin"])
    if not all(shutil.which(program, path=path) for program in programs):
        sys.exit(77)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        program = str(pathlib.Path(words.abrazo).resolve())
        (folder / "bin").mkdir()
        wrapper = folder / "bin" / "abrazo"
        wrapper.write_text(WRAPPER.format(folder=folder, program=program))
        wrapper.chmod(0o755)
        environment = {**os.environ, "PATH": os.pathsep.join([str(folder / "bin"), path])}
        run([program, "demo", "-o", "demo", "--minutes", "0.25", "--take-seconds", "7"], folder, environment)
        run([program, "sweep", "--quiet", *ARGUMENTS.format("alone").split()], folder, environment)
        for page in pathlib.Path(words.examples).iterdir():
            shutil.copy(page, folder)
        (folder / "sweep.args").write_text(ARGUMENTS.format("sweep"))
        start(folder, environment)
        assert (folder / "killed").exists(), "no shard was killed"
        started = [line.split("--shard ")[1].split("/")[0] for line in (folder / "started").read_text().splitlines()
                   if "--shard " in line]
        assert set(started) == {str(i) for i in range(1, SHARDS + 1)}, started
        alone, together = figures(folder / "alone" / "sweep.json"), figures(folder / "sweep" / "sweep.json")
        assert len(together) == 4 and together == alone, "the map differs from that of one process"
        print(f"{words.scheduler}: {len(together)} points as those of one process; shards begun: {' '.join(started)}")


if __name__ == "__main__":
    main()
