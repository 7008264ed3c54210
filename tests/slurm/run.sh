#!/bin/bash
# tests/slurm/run.sh [TERRVIEW [FOLDER]]: a batch as an array of 8 on a real Slurm of two nodes on
# this machine, one of which dies midway. Everything it starts it also stops; FOLDER (default: a
# temporary one) keeps the logs. Exit code 77 where Slurm is missing. As root: apt-get install
# slurm-wlm munge.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
terrview=$(realpath "${1:-$here/../../build/release/terrview}")
folder=$(realpath -m "${2:-$(mktemp -d)}")
views=200
shards=8

for tool in munged slurmctld slurmd sbatch squeue scontrol; do
  PATH=$PATH:/usr/sbin
  command -v "$tool" >/dev/null || { echo "slurm: skipped: there is no $tool here: install slurm-wlm and munge"; exit 77; }
done
((EUID == 0)) || { echo "slurm: skipped: its daemons need root here"; exit 77; }

mkdir -p "$folder"/{state,spool-one,spool-two,logs,munge}
cd "$folder"
export SLURM_CONF=$folder/slurm.conf
pids=()

stop() {
  scancel --full --quiet "${job:-0}" 2>/dev/null || true
  for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
  wait 2>/dev/null || true
}
trap stop EXIT

# What the daemons have to share.
write_configuration() {
  local cpus memory
  cpus=$(nproc)
  memory=$(awk '/MemTotal/ { print int($2 / 1024) }' /proc/meminfo)
  cat >slurm.conf <<END
ClusterName=terrview
SlurmctldHost=$(hostname -s)
SlurmctldPort=36817
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/logs/slurmctld
SlurmdLogFile=$folder/logs/slurmd-%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=2,batch_sched_delay=1
MinJobAge=600
SlurmdTimeout=8
ReturnToService=2
JobRequeue=1
NodeName=one,two NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=36818-36819 CPUs=$cpus RealMemory=$memory
PartitionName=all Nodes=one,two Default=YES State=UP MaxTime=INFINITE
END
}

start() {
  "$@" >>"logs/$1.out" 2>&1 &
  pids+=($!)
}

start_slurm() {
  dd if=/dev/urandom of=munge/key bs=128 count=1 status=none
  chmod 400 munge/key
  start munged --foreground --force --socket="$folder/munge/socket" --key-file="$folder/munge/key" \
    --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" --log-file="$folder/logs/munged"
  until [[ -S munge/socket ]]; do sleep 0.2; done
  start slurmctld -D
  start slurmd -D -N one
  start slurmd -D -N two
  node_two=$!
  for _ in {1..100}; do
    [[ $(sinfo -h -N -o %T 2>/dev/null | sort | uniq -c | tr -s ' ') == ' 2 idle' ]] && return
    sleep 0.3
  done
  echo "slurm: the nodes do not come up: see $folder/logs" >&2
  exit 1
}

# Processes of this Slurm's tasks on a node.
tasks_on() {
  local process
  for process in /proc/[0-9]*; do
    tr '\0' '\n' <"$process/environ" | grep -qx "SLURM_CONF=$SLURM_CONF" || continue
    tr '\0' '\n' <"$process/environ" | grep -qx "SLURMD_NODENAME=$1" || continue
    basename "$process"
  done 2>/dev/null
}

# A node without power: its daemon and all that it has started are gone at once.
kill_node_two() {
  local tasks task steps=()
  tasks=$(tasks_on two)
  for task in $tasks; do steps+=("$(ps -o ppid= -p "$task" | tr -d ' ')"); done
  kill -KILL "$node_two"
  wait "$node_two" 2>/dev/null || true
  for task in "${steps[@]}" $tasks; do
    [[ $task == 1 || $task == $$ ]] || kill -KILL "$task" 2>/dev/null || true
  done
}

written() { find o -name 'v*.png' 2>/dev/null | wc -l; }

"$terrview" synth --size 257x257 --first 3,5 --spacing 90 --height 400 --base 900 -q -o hills.tif --overwrite
{
  echo 'name,eye-xy,heading'
  for ((i = 0; i < views; ++i)); do
    echo "v$i,\"$((3000 + i * 80)),$((4000 + i * 70)),+60\",$((i * 37 % 360))"
  done
} >jobs.csv
batch=("$terrview" batch jobs.csv --dem hills.tif --size 640x360 -q)
"${batch[@]}" -o 'calm/{name}.png' --overwrite

cat >job.sh <<END
#!/bin/bash
#SBATCH --array=0-$((shards - 1)) --requeue --cpus-per-task=1
#SBATCH --output=logs/task-%a.out --open-mode=append
exec ${batch[*]} -o 'o/{name}.png' --threads 1 --resume
END

write_configuration
start_slurm
job=$(sbatch --parsable job.sh)
until (($(written) > views / 8)); do sleep 0.1; done
echo "slurm: $(written) views are there: node two dies with $(squeue -h -j "$job" -w two -t running | wc -l) tasks"
kill_node_two
until [[ $(sinfo -h -n two -o %T) == down* ]]; do sleep 0.5; done
echo "slurm: $(written) views are there: node two comes back"
start slurmd -D -N two
while [[ -n $(squeue -h -j "$job") ]]; do
  for task in $(squeue -h -j "$job" -t pending -o %F_%K); do
    scontrol update JobId="$task" StartTime=now 2>/dev/null || true
  done
  sleep 1
done

"$terrview" batch --merge o/jobs-*-of-$shards.jsonl -o all.jsonl --overwrite
diff -rq --exclude='*.jsonl' calm o
[[ -z $(find o -name '.*part*') ]]
echo "slurm: nothing is lost: $(written) views, the same bytes as undisturbed"
