#include "io/link.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "io/link_mpi.hpp"

namespace hawser::io {

namespace {

[[noreturn]] void end_all(ExitCode code, std::string_view message) {
    std::fprintf(stderr, "error: %.*s\n", static_cast<int>(message.size()), message.data());
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
    std::_Exit(static_cast<int>(code));
}

/// Ends all ranks if an MPI call did not succeed.
void check(int result, const char* call) {
    if (result == MPI_SUCCESS) return;
    char words[MPI_MAX_ERROR_STRING];
    int length = 0;
    if (MPI_Error_string(result, words, &length) != MPI_SUCCESS) length = 0;
    end_all(ExitCode::io, std::string(call) + ": " + std::string(words, size_t(length)));
}

int environment_number(const char* name) {
    const char* text = std::getenv(name);
    return text == nullptr ? -1 : std::atoi(text);
}

}  // namespace

Launch launch() {
    if (const int size = environment_number("OMPI_COMM_WORLD_SIZE"); size > 0)
        return {.rank = environment_number("OMPI_COMM_WORLD_RANK"), .size = size};
    if (const int rank = environment_number("PMIX_RANK"); rank >= 0)  // srun --mpi=pmix
        if (const int size = environment_number("SLURM_STEP_NUM_TASKS"); size > 0)
            return {.rank = rank, .size = size};
    return {};
}

std::string mpi_version() {
    char words[MPI_MAX_LIBRARY_VERSION_STRING];
    int length = 0;
    check(MPI_Get_library_version(words, &length), "MPI_Get_library_version");
    const std::string text(words, static_cast<std::size_t>(length));
    return text.substr(0, text.find(','));  // Open MPI goes on with where it was built
}

Link::Link() : handle_(std::make_unique<Handle>()) {}
Link::Link(std::unique_ptr<Handle> handle) : handle_(std::move(handle)) {}
Link::Link(Link&&) noexcept = default;
Link& Link::operator=(Link&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
}
Link::~Link() {
    if (handle_ && handle_->communicator != MPI_COMM_NULL)
        check(MPI_Comm_free(&handle_->communicator), "MPI_Comm_free");
}

int Link::rank() const { return handle_->rank; }
int Link::size() const { return handle_->size; }

Link Link::duplicate() const {
    auto copy = std::make_unique<Handle>(*handle_);
    if (copy->communicator != MPI_COMM_NULL) {
        check(MPI_Comm_dup(handle_->communicator, &copy->communicator), "MPI_Comm_dup");
        check(MPI_Comm_set_errhandler(copy->communicator, MPI_ERRORS_RETURN),
              "MPI_Comm_set_errhandler");
    }
    return Link(std::move(copy));
}

void Link::broadcast(std::span<double> values) const {
    if (alone()) return;
    check(MPI_Bcast(values.data(), static_cast<int>(values.size()), MPI_DOUBLE, 0,
                    handle_->communicator),
          "MPI_Bcast");
}

void Link::broadcast(int& value) const {
    if (alone()) return;
    check(MPI_Bcast(&value, 1, MPI_INT, 0, handle_->communicator), "MPI_Bcast");
}

void Link::broadcast(std::string& text) const {
    if (alone()) return;
    int length = static_cast<int>(text.size());
    broadcast(length);
    text.resize(static_cast<size_t>(length));
    check(MPI_Bcast(text.data(), length, MPI_CHAR, 0, handle_->communicator), "MPI_Bcast");
}

void Link::gather(std::span<const double> mine, std::span<const int> counts,
                  std::span<double> all) const {
    if (alone()) {
        std::copy(mine.begin(), mine.end(), all.begin());
        return;
    }
    std::vector<int>& starts = handle_->starts;
    if (rank() == 0) {
        if (counts.size() != static_cast<size_t>(size()))
            fail(ExitCode::bug, "Link::gather: one count per rank is needed");
        starts.resize(counts.size());
        int start = 0;
        for (size_t i = 0; i < counts.size(); ++i) {
            starts[i] = start;
            start += counts[i];
        }
        if (all.size() < static_cast<size_t>(start))
            fail(ExitCode::bug, "Link::gather: no room for what all ranks send");
    }
    check(MPI_Gatherv(mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, all.data(),
                      counts.data(), starts.data(), MPI_DOUBLE, 0, handle_->communicator),
          "MPI_Gatherv");
}

int Link::greatest(int mine) const {
    if (alone()) return mine;
    int all = 0;
    check(MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, handle_->communicator), "MPI_Allreduce");
    return all;
}

void Link::barrier() const {
    if (!alone()) check(MPI_Barrier(handle_->communicator), "MPI_Barrier");
}

void Link::fail(ExitCode code, std::string_view message) const {
    if (alone()) throw RunError(code, std::string(message));
    end_all(code, message);
}

MpiRuntime::MpiRuntime(int* argc, char*** argv) {
    check(MPI_Init(argc, argv), "MPI_Init");
    check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "MPI_Comm_set_errhandler");
}

MpiRuntime::~MpiRuntime() { check(MPI_Finalize(), "MPI_Finalize"); }

Link MpiRuntime::link() const {
    auto handle = std::make_unique<Link::Handle>();
    check(MPI_Comm_dup(MPI_COMM_WORLD, &handle->communicator), "MPI_Comm_dup");
    check(MPI_Comm_set_errhandler(handle->communicator, MPI_ERRORS_RETURN),
          "MPI_Comm_set_errhandler");
    check(MPI_Comm_rank(handle->communicator, &handle->rank), "MPI_Comm_rank");
    check(MPI_Comm_size(handle->communicator, &handle->size), "MPI_Comm_size");
    return Link(std::move(handle));
}

}  // namespace hawser::io
