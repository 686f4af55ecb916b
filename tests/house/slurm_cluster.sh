# shellcheck shell=bash
# A Slurm cluster of two nodes on this machine, without systemd: munge, slurmctld and two slurmd, all in the folder $cluster.
# Needs root, since slurmd starts the tasks of other users.

cluster_programs='munged slurmctld slurmd sbatch squeue scontrol'

# A free port for a listening program.
free_port() {
    local port
    for port in $(shuf -i 20000-29999 -n 50); do
        if ! (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; then
            echo "$port"
            return
        fi
    done
    return 1
}

cluster_start() { # FOLDER
    cluster=$1
    export SLURM_CONF=$cluster/slurm.conf
    mkdir -p "$cluster/log" "$cluster/state" "$cluster/spool.n1" "$cluster/spool.n2" "$cluster/munge"
    chmod 755 "$cluster" "$cluster/munge"
    local host socket=$cluster/munge/socket
    host=$(hostname -s)
    dd if=/dev/urandom of="$cluster/munge/key" bs=1024 count=1 2>/dev/null
    chmod 400 "$cluster/munge/key"
    munged --force --key-file="$cluster/munge/key" --socket="$socket" --pid-file="$cluster/munge/pid" \
        --log-file="$cluster/log/munge.log" --seed-file="$cluster/munge/seed" || return 1
    cat >"$SLURM_CONF" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$socket,cred_expire=5
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc=$cluster/log/jobcomp.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=2,bf_interval=2
ReturnToService=2
JobRequeue=1
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool.%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/slurmd.%n.pid
SlurmctldLogFile=$cluster/log/slurmctld.log
SlurmdLogFile=$cluster/log/slurmd.%n.log
SlurmctldTimeout=15
SlurmdTimeout=10
InactiveLimit=0
MinJobAge=300
KillWait=5
NodeName=n1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1 RealMemory=500 State=UNKNOWN
NodeName=n2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(free_port) CPUs=1 RealMemory=500 State=UNKNOWN
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
END
    slurmctld && slurmd -N n1 && slurmd -N n2 || return 1
    local try
    for try in $(seq 100); do
        [ "$(sinfo -h -o %T 2>/dev/null | sort -u)" = idle ] && return 0
        sleep 0.2
    done
    return 1
}

# The processes of the tasks that run on a node.
node_tasks() { # NODE
    grep -lsz "^SLURMD_NODENAME=$1\$" /proc/[0-9]*/environ | cut -d / -f 3
}

# Stops the clock of a node's tasks, so that none ends before the crash. Fails, and lets them run on, if none is in the program: a task whose
# program has ended is complete for the controller, which does not run it again.
cluster_freeze() { # NODE PROGRAM
    local tasks task
    tasks=$(node_tasks "$1")
    echo "$tasks" | xargs -r kill -STOP 2>/dev/null || true
    for task in $tasks; do
        case $(ps -o state=,comm= -p "$task" 2>/dev/null) in T*"$2") return 0 ;; esac
    done
    echo "$tasks" | xargs -r kill -CONT 2>/dev/null || true
    return 1
}

# Ends a node as a power cut does: its daemon first, so that nothing is started any more, then what waits for the tasks, then the tasks.
# The controller is told, as an operator would: its own pings can need minutes on a busy machine.
cluster_crash() { # NODE
    pkill -9 -f "slurmd -N $1\$" || true
    local task step
    for task in $(node_tasks "$1"); do
        step=$(ps -o ppid= -p "$task" | tr -d ' ')
        case $(ps -o args= -p "${step:-0}") in slurmstepd*) kill -9 "$step" 2>/dev/null || true ;; esac
        kill -9 "$task" 2>/dev/null || true
    done
    scontrol update NodeName="$1" State=DOWN Reason='power cut'
}

cluster_stop() {
    pkill -9 -F "$cluster/slurmctld.pid" 2>/dev/null || true
    pkill -9 -f "slurmd -N n[12]\$" || true
    pkill -9 -f "^slurmstepd" || true
    pkill -9 -F "$cluster/munge/pid" 2>/dev/null || true
}
