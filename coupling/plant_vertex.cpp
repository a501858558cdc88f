#include "coupling/plant_vertex.h"

#include "coupling/plant_numerics.h"

namespace windrow {

PlantKey place_key(float x, float z) {
    return numerics::windrow_place_key(x, z);
}

float plant_yaw(PlantKey key) {
    return numerics::windrow_plant_yaw(numerics::windrow_plant_hash(key));
}

float plant_stiffness(PlantKey key, float spread) {
    return numerics::windrow_plant_factor(numerics::windrow_plant_hash(key), spread);
}

} // namespace windrow
