// The link between the ranks of a run: the only speaker of MPI. A run alone is a link of size 1
// that never touches MPI. Every call is checked here; a failing one ends all ranks (README.md of
// common, "Ranks").
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "status.hpp"

namespace hawser::io {

/// How this process was started, read from the environment alone (no MPI call).
struct Launch {
    int rank = 0, size = 1;
    [[nodiscard]] bool alone() const { return size == 1; }
};
[[nodiscard]] Launch launch();

/// Name and version of the MPI library; MPI need not be started.
[[nodiscard]] std::string mpi_version();

/// Ranks that work on one run, with a communicator of their own. Every member function except
/// rank(), size() and fail() is collective: all ranks call it, in the same order.
class Link {
 public:
    Link();  ///< alone: rank 0 of 1, without MPI
    Link(Link&&) noexcept;
    Link& operator=(Link&&) noexcept;
    ~Link();

    [[nodiscard]] int rank() const;
    [[nodiscard]] int size() const;
    [[nodiscard]] bool alone() const { return size() == 1; }

    /// The same ranks with a communicator of their own, for one case of many.
    [[nodiscard]] Link duplicate() const;

    /// Rank 0's values to all.
    void broadcast(std::span<double> values) const;
    void broadcast(int& value) const;
    void broadcast(std::string& text) const;

    /// All ranks' values to rank 0, in rank order: `all` holds sum(counts) there and is not used
    /// elsewhere. @param counts numbers per rank, known to rank 0
    void gather(std::span<const double> mine, std::span<const int> counts,
                std::span<double> all) const;

    /// The greatest of all ranks' values, on every rank.
    [[nodiscard]] int greatest(int mine) const;
    void barrier() const;

    /// Ends the run because of something the ranks have not agreed on: alone throws RunError; with
    /// other ranks prints the message on one line and ends them all with this exit code.
    [[noreturn]] void fail(ExitCode code, std::string_view message) const;

    struct Handle;  ///< see link_mpi.hpp
    [[nodiscard]] const Handle& handle() const { return *handle_; }

 private:
    friend class MpiRuntime;
    explicit Link(std::unique_ptr<Handle> handle);
    std::unique_ptr<Handle> handle_;
};

/// MPI from construction to destruction; at most one per process, and every Link dies before it.
class MpiRuntime {
 public:
    MpiRuntime(int* argc, char*** argv);
    MpiRuntime(const MpiRuntime&) = delete;
    MpiRuntime& operator=(const MpiRuntime&) = delete;
    ~MpiRuntime();

    [[nodiscard]] Link link() const;  ///< a duplicate of the world, collective
};

}  // namespace hawser::io
