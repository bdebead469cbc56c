// synthetic_run KIND FOLDER SECONDS: a finished run's folder without physics, KIND one of spar,
// decay, chain. For tests of the scripts.
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
    if (argc != 4) {
        std::fprintf(stderr, "usage: synthetic_run spar|decay|chain FOLDER SECONDS\n");
        return 2;
    }
    const std::string kind = argv[1];
    const std::filesystem::path folder = argv[2];
    const double seconds = std::atof(argv[3]);
    std::optional<io::MpiRuntime> mpi;
    if (!io::launch().alone()) mpi.emplace(&argc, &argv);
    io::Link link = mpi ? mpi->link() : io::Link();
    try {
        const Case input = kind == "spar"    ? test::synthetic_spar(seconds)
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
        link.fail(error.code(), error.what());
    }
    return 0;
}
