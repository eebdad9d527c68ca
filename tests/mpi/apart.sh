#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# apart.sh COMMAND...: runs a command with a directory for temporary files of its own. Jobs of Open MPI that begin and end at the
# same time else share one, and the last that leaves it takes it away while another is about to enter (open-mpi/ompi, issue 8510).
TMPDIR=$(mktemp -d) || exit
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
"$@"
