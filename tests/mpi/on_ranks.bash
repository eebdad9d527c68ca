# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the tests in this folder, after their arguments KITH KITH_MPI SHIM: how they run kith-mpi.
source "$(dirname "${BASH_SOURCE[0]}")/../tool/check.bash"
kith_mpi=$2
shim=$3
# More ranks than processors and, in a container, root: what MPI refuses unless told.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_hwloc_base_binding_policy=none # else each of two ranks is bound to a processor that other tests also use
export OMPI_MCA_mpi_yield_when_idle=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
export OMPI_MCA_pml=ob1 # what Open MPI takes on one machine; to look for hardware of others first is half the time of a small job
export TMPDIR=$results # of this test alone, see apart.sh

# on RANKS ARGUMENTS...: runs kith-mpi there.
on() {
    local ranks=$1
    shift
    command="mpirun -n $ranks kith-mpi $*"
    timeout 120 mpirun -n "$ranks" "$kith_mpi" "$@" >"$results/out" 2>"$results/err" </dev/null
    code=$?
}
one_message() { check "should say one thing" test "$(grep -c '^kith-mpi: ' "$results/err")" -eq 1; }
