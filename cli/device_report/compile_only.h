// A host whose pipelines are compiled by the driver and whose memory is none of the device's: for a driver without a device, which has
// no memory types.
#pragma once

#include "fluid/vulkan/host.h"

namespace windrow::cli {

/// `host` with calls that make no memory, images or descriptor sets. Objects made with it can be created and destroyed; what
/// they record must not be submitted. One host at a time.
[[nodiscard]] vulkan::Host compile_only(const vulkan::Host& host);

} // namespace windrow::cli
