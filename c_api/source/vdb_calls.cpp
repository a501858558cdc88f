// What the library that holds OpenVDB consists of: one function, which libwindrow calls.
#include "c_api/base.h"
#include "c_api/source/vdb_library.h"

namespace windrow::c_api {
namespace {

// Functions of our own: what crosses the boundary takes and returns objects, and throws nothing.
vdb::WriteResult write_file(const vdb::VelocityGrid& grid, const std::filesystem::path& file, const vdb::Options& options) {
    return vdb::write(grid, file, options);
}
vdb::WriteResult write_frame(const vdb::Sequence& sequence, const vdb::VelocityGrid& grid, int frame, double time) {
    return sequence.write(grid, frame, time);
}

constexpr VdbCalls k_calls{
    .layout = k_vdb_layout, .write = write_file, .write_frame = write_frame, .has_nanovdb = vdb::has_nanovdb};

} // namespace
} // namespace windrow::c_api

extern "C" WINDROW_C_API const windrow::c_api::VdbCalls* windrow_openvdb(void);
const windrow::c_api::VdbCalls* windrow_openvdb(void) {
    return &windrow::c_api::k_calls;
}
