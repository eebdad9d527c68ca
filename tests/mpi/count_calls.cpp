// SPDX-License-Identifier: BSD-3-Clause
// Counts the calls of a program that communicate, through the profiling interface of MPI. Calls between MPI_Pcontrol(1)
// and MPI_Pcontrol(0) are counted separately.
#include <mpi.h>
#include <cstdio>

static int refining = 0;
static long calls[2] = {0, 0};

extern "C" int MPI_Pcontrol(const int level, ...)
{
    refining = level != 0;
    return MPI_SUCCESS;
}

#define COUNTED(name, parameters, arguments)                                                                           \
    extern "C" int name parameters                                                                                     \
    {                                                                                                                  \
        ++calls[refining];                                                                                             \
        return P##name arguments;                                                                                      \
    }                                                                                                                  \
    static_assert(true, "") // so that a use ends with a semicolon

COUNTED(MPI_Send, (const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c), (b, n, t, to, tag, c));
COUNTED(MPI_Isend, (const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r),
        (b, n, t, to, tag, c, r));
COUNTED(MPI_Recv, (void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Status* s),
        (b, n, t, from, tag, c, s));
COUNTED(MPI_Irecv, (void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Request* r),
        (b, n, t, from, tag, c, r));
COUNTED(MPI_Probe, (int from, int tag, MPI_Comm c, MPI_Status* s), (from, tag, c, s));
COUNTED(MPI_Iprobe, (int from, int tag, MPI_Comm c, int* is_there, MPI_Status* s), (from, tag, c, is_there, s));
COUNTED(MPI_Ibcast, (void* b, int n, MPI_Datatype t, int root, MPI_Comm c, MPI_Request* r), (b, n, t, root, c, r));
COUNTED(MPI_Iallreduce, (const void* b, void* s, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c, MPI_Request* r),
        (b, s, n, t, o, c, r));
COUNTED(MPI_Test, (MPI_Request * r, int* is_done, MPI_Status* s), (r, is_done, s));
COUNTED(MPI_Bcast, (void* b, int n, MPI_Datatype t, int root, MPI_Comm c), (b, n, t, root, c));
COUNTED(MPI_Barrier, (MPI_Comm c), (c));
COUNTED(MPI_Allreduce, (const void* b, void* r, int n, MPI_Datatype t, MPI_Op o, MPI_Comm c), (b, r, n, t, o, c));
COUNTED(MPI_Reduce, (const void* b, void* r, int n, MPI_Datatype t, MPI_Op o, int root, MPI_Comm c),
        (b, r, n, t, o, root, c));
COUNTED(MPI_Gather, (const void* b, int n, MPI_Datatype t, void* r, int m, MPI_Datatype u, int root, MPI_Comm c),
        (b, n, t, r, m, u, root, c));
COUNTED(MPI_Allgather, (const void* b, int n, MPI_Datatype t, void* r, int m, MPI_Datatype u, MPI_Comm c),
        (b, n, t, r, m, u, c));
COUNTED(MPI_Alltoall, (const void* b, int n, MPI_Datatype t, void* r, int m, MPI_Datatype u, MPI_Comm c),
        (b, n, t, r, m, u, c));

extern "C" int MPI_Finalize()
{
    std::fprintf(stderr, "refinement: %ld calls\nelsewhere: %ld calls\n", calls[1], calls[0]);
    return PMPI_Finalize();
}
