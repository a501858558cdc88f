// A file of the host's own: a crate of drinks. The library has a fluid/box.h too, and neither may take the other's place.
#pragma once

namespace game {
struct Box {
    int bottles = 12;
};
} // namespace game
