// What a test under mpirun sees of its ranks. The main in ranks.cpp starts MPI, prints on rank 0
// only, and ends every rank with the worst result of all.
#pragma once

#include "io/link.hpp"

namespace hawser::test {

/// The link over all ranks of the test (a duplicate of the world).
io::Link& ranks();

}  // namespace hawser::test
