#include "hulls.hpp"

#include <optional>

#include "io/hydro_file.hpp"

namespace hawser::master {

std::vector<Hull> hulls_of(const Case& input) {
    std::vector<Hull> hulls;
    for (int k = 0; k < input.platform_count(); ++k) {
        std::optional<HydroData> hydro;
        if (const auto& database = input.platform_at(k).hydrodynamics.database)
            hydro = io::read_hydro(*database, input.environment);
        hulls.emplace_back(input, hydro ? &*hydro : nullptr, k);
    }
    return hulls;
}

}  // namespace hawser::master
