// What went into a run of WAMIT, read to hold its results and the case against: the panels of the
// .gdf and the control of forces .frc (WAMIT manual, ch. 4 and 6). Neither is needed.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hull_panels.hpp"
#include "io/hydro_file.hpp"

namespace hawser::io {

struct HydroSet;

/// A .gdf: title; ULEN GRAV; ISX ISY; NPAN; the corners of the panels. GRAV of feet makes
/// everything here metres.
struct WamitGeometry {
    std::filesystem::path file;
    double ulen = 0.0, gravity = 0.0;  ///< [m], [m/s2]
    bool in_feet = false;
    bool yz = false, xz = false;            ///< planes of symmetry: ISX, ISY
    std::optional<PanelHydrostatics> hull;  ///< none of a higher-order geometry
    std::string unread;                     ///< why the panels say nothing; empty: they do
    int unread_line = 0;
};

/// A .frc, form 1: title; IOPTN; VCG; three rows of radii of gyration. Form 2: title; IOPTN; RHO;
/// XCG YCG ZCG; IMASS, and the mass matrix if that is 1. Lengths as the file has them.
struct WamitControl {
    std::filesystem::path file;
    std::vector<int> options;  ///< IOPTN, from the first
    int form = 0;              ///< 1 or 2; 0: neither, nothing below is known
    double density = 0.0;      ///< of form 2
    double z_G = 0.0;          ///< VCG or ZCG
    int z_G_line = 0;
    std::optional<double> mass;  ///< of form 2 with a mass matrix
};

/// The two files beside a set; none where there is no such file.
std::optional<WamitGeometry> read_wamit_geometry(const std::filesystem::path& file);
std::optional<WamitControl> read_wamit_control(const std::filesystem::path& file);

/// The results and the case against both, about the files' own origin. `stiffness` is C as the
/// .hst has it.
std::vector<PlacedCheck> check_wamit_inputs(const HydroDatabase& database, const HydroSet& set,
                                            const HydroData& data);

}  // namespace hawser::io
