#!/usr/bin/env bash
#==========================================================================
#
#   Copyright NumFOCUS
#
#   Licensed under the Apache License, Version 2.0 (the "License");
#   you may not use this file except in compliance with the License.
#   You may obtain a copy of the License at
#
#          https://www.apache.org/licenses/LICENSE-2.0.txt
#
#   Unless required by applicable law or agreed to in writing, software
#   distributed under the License is distributed on an "AS IS" BASIS,
#   WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#   See the License for the specific language governing permissions and
#   limitations under the License.
#
#==========================================================================
# usage: single-node.sh FOLDER COMMAND...
# Runs a command on a Slurm of its own, of this machine alone: installs Debian's slurm-wlm where that is missing, starts its
# programs on the loopback address with all they write in FOLDER, and stops them when the command has ended. To try
# things, not to work: there is no accounting, and all runs as root.
#
#   SINGLE_NODE_PORT   the first of two ports to listen on; default: 26817
set -euo pipefail

fail() {
  echo "single-node.sh: $1" >&2
  exit 1
}
[ $# -ge 2 ] || fail "usage: single-node.sh FOLDER COMMAND..."
[ "$(id -u)" -eq 0 ] || fail "Slurm starts jobs as root only; run it as root, or in a container"
[ ! -e /etc/slurm/slurm.conf ] && [ ! -e /run/slurm/conf ] ||
  fail "this machine has a Slurm already (/etc/slurm/slurm.conf or /run/slurm/conf); use that"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
"$(dirname "$0")/../../../scripts/apt-install.sh" munge slurm-wlm

memory=$(awk '/^MemTotal/ { print int($2 / 1024) }' /proc/meminfo)
port=${SINGLE_NODE_PORT:-26817}
mkdir -p "$folder/state" "$folder/spool"
chmod 755 "$folder"
export SLURM_CONF=$folder/slurm.conf
cat > "$SLURM_CONF" << EOF
ClusterName=single
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
# no control groups, which containers do not have
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
# squeue tells what became of a job for so many seconds
MinJobAge=3600
KillWait=2
MpiDefault=none
SwitchType=switch/none
ReturnToService=2
NodeName=single NodeHostname=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=single Default=YES MaxTime=INFINITE State=UP
EOF

# where programs look that are without SLURM_CONF, such as those that Snakemake starts within a job
mkdir -p /run/slurm
ln -sfn "$folder" /run/slurm/conf
processes=()
stop() {
  rm -f /run/slurm/conf
  for ((n = ${#processes[@]} - 1; n >= 0; --n)); do
    kill "${processes[n]}" 2> /dev/null && wait "${processes[n]}" 2> /dev/null || true
  done
}
trap stop EXIT
[ -e "$folder/munge.key" ] || (umask 077 && head -c 1024 /dev/urandom > "$folder/munge.key")
munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munged.pid" --seed-file="$folder/munged.seed" --log-file="$folder/munged.log" > "$folder/munged.out" 2>&1 &
processes+=($!)
for ((n = 0; n < 50; ++n)); do
  [ ! -S "$folder/munge.socket" ] || break
  sleep 0.2
done
slurmctld -D > "$folder/slurmctld.out" 2>&1 &
processes+=($!)
slurmd -D -N single > "$folder/slurmd.out" 2>&1 &
processes+=($!)
for ((n = 0; n < 60; ++n)); do
  [ "$(sinfo --noheader --format %T 2> /dev/null)" != idle ] || break
  sleep 0.5
done
[ "$(sinfo --noheader --format %T 2> "$folder/sinfo.out")" = idle ] ||
  fail "Slurm's node is not idle after 30 s; $folder/slurmctld.log and slurmd.log say why"
"$@"
