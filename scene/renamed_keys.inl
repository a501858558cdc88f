// Keys of scene files that have another name now, old then new. A scene with an old key is rejected with a sentence that names the
// new one; tools/rename_scene.py (./dev rename-scene) reads this list too. An old name here is the name of no other key.
{"sides", "boundaries"}, {"settling_time", "relaxation_time"}, {"rim", "blend_width"}, {"settle", "warm_up"},
    {"trail_share", "trail_fraction"}, {"wind_share", "wind_fraction"}, {"own_bend", "rest_bend"},
    {"own_bend_spread", "rest_bend_spread"}, {"own_curve", "rest_curve"}, {"least_shells", "min_shells"},
    {"least_width", "min_width"}, {"longest_stride", "max_stride"}, {"most_bend", "max_bend"}, {"most_blades", "max_blades"},
    {"most_chunks", "max_chunks"}, {"most_triangles", "max_triangles"}, {"most_walkers", "max_walkers"},
