#include "fluid/canopy.h"

#include "fluid/validation.h"

namespace windrow {

Result<void> validate(const Canopy& canopy) {
    return detail::validate_settings(canopy, "canopy");
}

} // namespace windrow
