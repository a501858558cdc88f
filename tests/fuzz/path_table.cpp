// Tables of paths: CSV of t, x, y, z.
#include "scene/motion_path.h"
#include "tests/fuzz/fuzz_target.h"

namespace windrow::fuzz {

ReadOutcome read_input(std::string_view bytes) {
    return outcome_of(static_cast<bool>(scene::parse_path_csv(bytes, "path.csv")));
}

} // namespace windrow::fuzz
