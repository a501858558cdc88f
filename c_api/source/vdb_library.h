// OpenVDB's part of the interface, in a library of its own beside libwindrow. The first call that writes a file opens it, so that a host
// that writes none loads none of OpenVDB's libraries and has none of their threads.
#pragma once

#include "fluid/vdb/vdb_export.h"
#include "fluid/version.h"

#include <array>
#include <cstddef>
#include <filesystem>

namespace windrow::c_api {

/// What both libraries must agree on: they hand each other objects of C++.
using VdbLayout = std::array<std::size_t, 5>;
inline constexpr VdbLayout k_vdb_layout{WINDROW_VERSION, sizeof(vdb::VelocityGrid), sizeof(vdb::Options), sizeof(vdb::Sequence),
                                        sizeof(vdb::WriteResult)};

/// The calls of the library, by its one function, windrow_openvdb.
struct VdbCalls {
    VdbLayout layout;
    vdb::WriteResult (*write)(const vdb::VelocityGrid& grid, const std::filesystem::path& file, const vdb::Options& options);
    vdb::WriteResult (*write_frame)(const vdb::Sequence& sequence, const vdb::VelocityGrid& grid, int frame, double time);
    bool (*has_nanovdb)();
};

/// Opens the library with the first call that finds it. The error names what is missing.
[[nodiscard]] Result<const VdbCalls*> vdb_calls();

} // namespace windrow::c_api
