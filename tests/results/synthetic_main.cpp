// synthetic_main KIND FOLDER SECONDS [BYTES]: a finished run's folder without physics, KIND one of
// spar, pair, decay, chain. BYTES limits the size of every file, like a disk that fills up. For
// tests of what comes after a simulation.
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "io/run_folder.hpp"
#include "io/series_file.hpp"
#include "io/summary.hpp"
#include "synthetic_run.hpp"

int main(int argc, char** argv) {
    using namespace hawser;
    if (argc != 4 && argc != 5) {
        std::fprintf(stderr,
                     "usage: synthetic_main spar|pair|decay|chain FOLDER SECONDS [BYTES]\n");
        return 2;
    }
    const std::string kind = argv[1];
    const std::filesystem::path folder = argv[2];
    const double seconds = std::atof(argv[3]);
    std::optional<io::MpiRuntime> mpi;
    if (!io::launch().alone()) mpi.emplace(&argc, &argv);
    io::Link link = mpi ? mpi->link() : io::Link();
    if (argc == 5) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlim_t bytes = std::strtoul(argv[4], nullptr, 10);
        const rlimit limit{.rlim_cur = bytes, .rlim_max = bytes};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    try {
        const Case input = kind == "spar"    ? test::synthetic_spar(seconds)
                           : kind == "pair"  ? test::synthetic_pair(seconds)
                           : kind == "decay" ? test::synthetic_decay(seconds)
                                             : test::synthetic_chain(seconds);
        if (link.rank() == 0) io::prepare_run_folder(folder, true);
        link.barrier();
        test::record_synthetic(folder, input, link, 100, [&](int n) {
            if (link.rank() != 0) return;
            std::printf("segment %d\n", n);
            std::fflush(stdout);
        });
        if (link.rank() == 0) {
            const io::RunRecord record = test::synthetic_record(input, link.size());
            io::write_summary(folder, record, io::write_result(folder, record));
        }
        link.barrier();
    } catch (const RunError& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return static_cast<int>(error.code());
    }
    return 0;
}
