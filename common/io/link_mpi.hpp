// What the HDF5 door needs of the link: its communicator. Private to common/io.
#pragma once

#include <mpi.h>

#include <vector>

#include "io/link.hpp"

namespace hawser::io {

struct Link::Handle {
    MPI_Comm communicator = MPI_COMM_NULL;  ///< MPI_COMM_NULL: alone, MPI may not be started
    int rank = 0, size = 1;
    std::vector<int> starts;  ///< of each rank's part in gather()
};

/// Communicator of the link; MPI_COMM_NULL for a run alone (open files without the MPI driver).
inline MPI_Comm communicator(const Link& link) { return link.handle().communicator; }

}  // namespace hawser::io
