// Plants, the ground's memory, scenes and winds on a device by hosts of other axes and units.
#include "tests/c_api/axes_host.h"

#include <array>
#include <string>
#include <vector>

namespace {

using namespace windrow::test;

void record_vertex(Record& record, const windrow_plant_vertex& vertex) {
    record.vector("vertex.position", vertex.position, 1);
    record.vector("vertex.normal", vertex.normal, 0);
    record.vector("vertex.tangent", vertex.tangent, 0);
}

TEST(AxesInC, StalksAndBladesBendTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_drag drag;
        WINDROW_AXES_OK(windrow_drag_init(&drag, sizeof drag));
        record.number("default width", static_cast<double>(drag.width), 1);
        WINDROW_AXES_OK(windrow_drag_of(WINDROW_PLANT_REED, &drag));
        record.number("reed.rigidity", static_cast<double>(drag.rigidity), 3);
        record.number("reed.air_density", static_cast<double>(drag.air_density), -3);
        WINDROW_AXES_OK(windrow_drag_validate(&drag));
        windrow_drag_block drag_block;
        WINDROW_AXES_OK(windrow_drag_block_of(&drag, &drag_block));
        record.number("drag block", static_cast<double>(drag_block.load.x));
        double cauchy = 0.0;
        WINDROW_AXES_OK(windrow_cauchy_number(&drag, host.number(6.0), &cauchy));
        record.number("cauchy", cauchy);
        float angle = 0.0f;
        WINDROW_AXES_OK(windrow_bend_angle(&drag, host.single(6.0), &angle));
        record.number("angle", static_cast<double>(angle));
        const float young = host.single(4e9, -1);
        const auto length = [&](double metres) { return host.single(metres); };
        record.number("rectangle", 1e6 * static_cast<double>(windrow_rectangle_rigidity(young, length(0.004), length(0.0005))),
                      3);
        record.number("folded",
                      1e6 * static_cast<double>(windrow_folded_rigidity(young, length(0.004), length(0.0005), length(0.001))), 3);
        record.number("rod", 1e6 * static_cast<double>(windrow_rod_rigidity(young, length(0.003))), 3);
        record.number("tube", 1e6 * static_cast<double>(windrow_tube_rigidity(young, length(0.004), length(0.003))), 3);

        windrow_blade_settings settings;
        WINDROW_AXES_OK(windrow_blade_settings_init(&settings, sizeof settings));
        drag.length = host.single(0.5);
        settings.stalk = &drag;
        settings.width = host.single(0.0078125);
        windrow_blades* blades = nullptr;
        WINDROW_AXES_OK(windrow_blades_create(&settings, &blades));
        const windrow_vec2 place = host.level(2.5, -1.25, 1);
        const windrow_plant_key hashed = windrow_place_key(place.x, place.y);
        record.exact("key", hashed.x);
        const windrow_plant_key key{12345u, 678u};
        const double sign = static_cast<double>(host.level(0.0, 1.0, 0).y);
        record.number("yaw", sign * static_cast<double>(windrow_plant_yaw(key)));
        record.number("length", static_cast<double>(windrow_blades_length(blades, key)), 1);
        const windrow_vec3 load = windrow_blades_load(blades, key, host.vector(3.0, 0.0, -1.5, 1));
        record.vector("load", load, 0);
        windrow_plant_vertex vertex;
        WINDROW_AXES_OK(windrow_blades_vertex(blades, key, load, 0.75f, 0.5f, host.vector(0.0, -0.5, 0.75, 0), &vertex));
        record_vertex(record, vertex);
        const std::array keys{key, windrow_plant_key{3u, 4u}};
        const std::array winds{host.vector4(2.0, 0.0, 1.0, 1), host.vector4(-1.0, 0.25, 3.0, 1)};
        std::array<windrow_vec4, 2> loads{};
        WINDROW_AXES_OK(windrow_blades_loads(blades, 2, keys.data(), winds.data(), loads.data(), nullptr));
        for (const windrow_vec4& one : loads)
            record.vector("loads", one, 0);
        const std::array roots{host.vector4(1.0, 0.0, 2.0, 1), host.vector4(-3.0, 0.5, 0.25, 1)};
        const std::array heights{0.0f, 0.5f, 1.0f};
        std::array<windrow_vec4, 12> positions{}, normals{};
        WINDROW_AXES_OK(windrow_blades_vertices(blades, 2, keys.data(), roots.data(), loads.data(), heights.size(),
                                                heights.data(), host.vector(0.0, 0.0, 1.0, 0), positions.data(), normals.data(),
                                                nullptr));
        for (std::size_t n = 0; n < positions.size(); ++n) {
            record.vector("positions", positions[n], 1);
            record.vector("normals", normals[n], 0);
            record.number("h", static_cast<double>(positions[n].w));
        }
        windrow_blades_destroy(blades);
    });
}

TEST(AxesInC, ShellsAndTreesBendTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_shell_settings fur;
        WINDROW_AXES_OK(windrow_shell_settings_init(&fur, sizeof fur));
        record.vector("default down", fur.down, 0);
        windrow_drag strand;
        WINDROW_AXES_OK(windrow_drag_init(&strand, sizeof strand));
        WINDROW_AXES_OK(windrow_drag_of(WINDROW_PLANT_GRASS, &strand));
        fur.strand = &strand;
        fur.push = host.single(0.03125);
        fur.droop = host.single(0.015625);
        fur.down = host.vector(0.25, -1.0, 0.5, 0);
        windrow_shells* shells = nullptr;
        WINDROW_AXES_OK(windrow_shells_create(&fur, &shells));
        const windrow_vec3 skin_at = host.vector(1.0, 2.0, -0.5, 1), up = host.vector(0.6, 0.8, 0.0, 0);
        const windrow_vec3 load = windrow_shells_load(shells, up, 0.75f, host.vector(4.0, 0.0, 2.0, 1));
        record.vector("load", load, 0);
        record.vector("bent", windrow_shells_bent(shells, skin_at, up, 0.5f, 0.75f, load), 1);
        record.vector("translated", windrow_shells_translated(shells, skin_at, up, 0.5f, 0.75f, host.vector(0.5, 0.0, 0.25, 0)),
                      1);
        const std::array positions{host.vector4(1.0, 2.0, -0.5, 1, 0.75f), host.vector4(0.0, 1.0, 2.0, 1, 1.0f)};
        const std::array normals{host.vector4(0.6, 0.8, 0.0, 0), host.vector4(0.0, 0.6, -0.8, 0)};
        const windrow_skin skin{positions.size(), positions.data(), normals.data()};
        const std::array winds{host.vector4(4.0, 0.0, 2.0, 1), host.vector4(-2.0, 1.0, 0.0, 1)};
        const std::array directions{host.vector4(0.5, 0.0, 0.25, 0), host.vector4(0.0, 0.0, 1.0, 0)};
        std::array<windrow_vec4, 2> loads{}, out{};
        WINDROW_AXES_OK(windrow_shells_loads_many(shells, &skin, winds.data(), loads.data(), nullptr));
        WINDROW_AXES_OK(windrow_shells_bent_many(shells, &skin, 0.5f, loads.data(), out.data(), nullptr));
        for (const windrow_vec4& one : out)
            record.vector("bent, many", one, 1);
        WINDROW_AXES_OK(windrow_shells_translated_many(shells, &skin, 0.5f, directions.data(), out.data(), nullptr));
        for (const windrow_vec4& one : out)
            record.vector("translated, many", one, 1);
        windrow_shells_destroy(shells);

        windrow_tree_classes classes;
        WINDROW_AXES_OK(windrow_tree_classes_init(&classes, sizeof classes));
        windrow_drag trunk_class;
        WINDROW_AXES_OK(windrow_drag_init(&trunk_class, sizeof trunk_class));
        WINDROW_AXES_OK(windrow_drag_of(WINDROW_PLANT_SMALL_TRUNK, &trunk_class));
        classes.trunk = &trunk_class;
        windrow_tree* tree = nullptr;
        WINDROW_AXES_OK(windrow_tree_create(&classes, &tree));
        const std::array parts{
            windrow_tree_part{host.vector(0.0, 0.0, 0.0, 1), host.vector(0.0, 1.0, 0.0, 0), host.single(4.0), 1.0f},
            windrow_tree_part{host.vector(0.0, 3.0, 0.0, 1), host.vector(0.6, 0.0, 0.8, 0), host.single(1.5), 1.0f}};
        windrow_plant_vertex rest{host.vector(0.75, 3.25, 0.5, 1), host.vector(0.0, 0.0, 1.0, 0), host.vector(1.0, 0.0, 0.0, 0)},
            bent{};
        WINDROW_AXES_OK(windrow_tree_vertex(tree, &parts[0], &parts[1], nullptr, host.vector(8.0, 0.0, 3.0, 1), &rest, &bent));
        record_vertex(record, bent);
        const std::array part_winds{host.vector4(8.0, 0.0, 3.0, 1), host.vector4(6.0, 0.0, -2.0, 1)};
        const windrow_vec4 rest_position = host.vector4(0.75, 3.25, 0.5, 1), rest_normal = host.vector4(0.0, 0.0, 1.0, 0);
        const windrow_tree_bearers bearers{0, 1, WINDROW_NO_PART};
        windrow_vec4 position{}, normal{};
        WINDROW_AXES_OK(windrow_tree_vertices(tree, parts.size(), parts.data(), part_winds.data(), 1, &rest_position,
                                              &rest_normal, &bearers, &position, &normal, nullptr));
        record.vector("tree", position, 1);
        record.vector("tree normal", normal, 0);
        windrow_tree_destroy(tree);
        windrow_flutter_class flutter{6.0, 0.5f, host.single(2.0)};
        windrow_flutter_block block;
        WINDROW_AXES_OK(windrow_flutter_step_make(&flutter, 1.0, 0.0625, &block));
        record.bytes(&block, sizeof block);
    });
}

void record_pose(Record& record, const windrow_pose& pose) {
    record.vector("pose.position", pose.position, 1);
    record.turn("pose.rotation", pose.rotation);
    record.number("pose.scale", pose.scale);
}
windrow_pose pose_of(const Host& host, double x, double angle) {
    const windrow_quat q = host.turn(0.25, 1.0, 0.5, angle);
    return {host.place(x, 1.0, -2.0),
            {static_cast<double>(q.x), static_cast<double>(q.y), static_cast<double>(q.z), static_cast<double>(q.w)},
            1.0};
}

TEST(AxesInC, CascadesAndTheGroundRememberTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_cascade_config lag;
        WINDROW_AXES_OK(windrow_cascade_config_init(&lag, sizeof lag));
        windrow_pose pose = pose_of(host, 0.0, 0.25);
        windrow_cascade* cascade = nullptr;
        WINDROW_AXES_OK(windrow_cascade_create(&lag, &pose, &cascade));
        pose = pose_of(host, 0.5, 0.5);
        WINDROW_AXES_OK(windrow_cascade_reset(cascade, &pose));
        pose = pose_of(host, 1.0, 1.0);
        WINDROW_AXES_OK(windrow_cascade_advance(cascade, 0.0625, &pose));
        WINDROW_AXES_OK(windrow_cascade_move(cascade, host.place(2.0, 0.5, -1.0)));
        WINDROW_AXES_OK(windrow_cascade_at(cascade, 0.75, &pose));
        record_pose(record, pose);
        WINDROW_AXES_OK(windrow_cascade_previous_at(cascade, 0.75, &pose));
        record_pose(record, pose);
        const windrow_pose_block* blocks = nullptr;
        std::uint64_t count = 0;
        WINDROW_AXES_OK(windrow_cascade_shader_poses(cascade, host.place(1.0, 0.0, 0.0), &blocks, &count));
        record.number("shader pose", static_cast<double>(blocks[count - 1].place.z));
        WINDROW_AXES_OK(windrow_cascade_previous_shader_poses(cascade, host.place(1.0, 0.0, 0.0), &blocks, &count));
        record.number("previous shader pose", static_cast<double>(blocks[count - 1].place.x));
        windrow_cascade_destroy(cascade);

        windrow_ground_config config;
        WINDROW_AXES_OK(windrow_ground_config_init(&config, sizeof config));
        config.texels = 32;
        windrow_ground* ground = nullptr;
        WINDROW_AXES_OK(windrow_ground_create(&config, nullptr, &ground));
        WINDROW_AXES_OK(windrow_ground_follow(ground, host.place(3.0, 0.0, -2.0)));
        windrow_ground_step step;
        WINDROW_AXES_OK(windrow_ground_step_init(&step, sizeof step));
        const windrow_ground_walker walker{host.place(3.5, 0.25, -1.5),
                                           host.place(3.25, 0.25, -1.75),
                                           host.single(0.125),
                                           host.single(0.0625),
                                           host.single(0.5),
                                           1.0f};
        step.duration = 0.0625;
        step.wind_lean = host.level(0.25, 0.125, 0);
        step.walker_count = 1;
        step.walkers = &walker;
        for (int n = 0; n < 3; ++n)
            WINDROW_AXES_OK(windrow_ground_advance(ground, &step, nullptr, 0));
        windrow_ground_sample sample{};
        WINDROW_AXES_OK(windrow_ground_at(ground, host.place(3.625, 0.0, -1.25), &sample));
        record.level("lean", sample.lean, 0);
        record.number("trample", static_cast<double>(sample.trample));
        WINDROW_AXES_OK(windrow_ground_previous_at(ground, host.place(3.625, 0.0, -1.25), &sample));
        record.level("previous lean", sample.lean, 0);
        record.level("next centre", windrow_ground_next_centre(ground, {3, 5}), 1);
        windrow_ground_block block;
        WINDROW_AXES_OK(windrow_ground_block_of(ground, host.place(2.0, 0.0, 0.5), &block));
        record.bytes(&block, sizeof block);
        WINDROW_AXES_OK(windrow_ground_shift_origin(ground, host.place(8.0, 0.0, 4.0)));
        const windrow_vec4* texels = windrow_ground_texels(ground, &count);
        record.bytes(texels, count * sizeof *texels);
        windrow_ground_destroy(ground);
    });
}

TEST(AxesInC, AScenesReportIsTheHosts) {
    if (!windrow_has_part(WINDROW_PART_SCENE))
        GTEST_SKIP();
    expect_same_for_all_hosts([](const Host&, Record& record) {
        const std::string text = R"({"duration": 1, "air": {"cells": [12, 8, 10], "ambient": [3, 0, 1]}})";
        windrow_scene* scene = nullptr;
        WINDROW_AXES_OK(windrow_scene_parse(text.data(), text.size(), "scene.json", nullptr, &scene));
        windrow_diagnostics report;
        WINDROW_AXES_OK(windrow_diagnostics_init(&report, sizeof report));
        WINDROW_AXES_OK(windrow_scene_step(scene, &report));
        record.number("max_speed", static_cast<double>(report.max_speed), 1);
        record.vector("ambient", windrow_wind_ambient(windrow_scene_wind(scene)), 1);
        windrow_scene_destroy(scene);
    });
}

struct Recording {
    windrow_wind* wind = nullptr;
    windrow_vulkan_ground* ground = nullptr;
    windrow_vulkan_frame frame{};
    windrow_ground_step step{};
    windrow_diagnostics report{};
    windrow_advance advance{};
    bool ticks = false;
    windrow_result result = WINDROW_OK;
};
void record_commands(void* commands, void* user) {
    auto& what = *static_cast<Recording*>(user);
    if (what.ground != nullptr)
        what.result = windrow_vulkan_ground_record(what.ground, commands, &what.step, WINDROW_LEANS_EVERYWHERE);
    else if (what.ticks)
        what.result = windrow_vulkan_wind_record(what.wind, commands, &what.frame, &what.advance, &what.report);
    else
        what.result = windrow_vulkan_wind_record_step(what.wind, commands, &what.frame, &what.report);
}

void device_story(const Host& host, Record& record, windrow_vulkan_device* device, const windrow_vulkan_host& from) {
    windrow_config config;
    WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
    config.cells = host.cells(16, 8, 12);
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = host.vector(3.0, 0.0, 1.0, 1);
    windrow_vulkan_settings settings;
    WINDROW_AXES_OK(windrow_vulkan_settings_init(&settings, sizeof settings));
    settings.queries = WINDROW_VULKAN_READ_BOX;
    settings.read_cells = host.cells(8, 6, 10);
    settings.frames_in_flight = 1;
    std::uint64_t memory = 0, reserved = 0;
    WINDROW_AXES_OK(windrow_vulkan_wind_required_bytes(&from, &config, &settings, &memory, &reserved));
    record.number("memory", static_cast<double>(memory));
    std::array<std::byte, 256> info{}; // a VkSamplerCreateInfo, and more
    WINDROW_AXES_OK(windrow_vulkan_sampler_info(&config.boundaries, info.data()));
    record.bytes(info.data() + 16, 64);
    Recording what;
    WINDROW_AXES_OK(windrow_vulkan_wind_create(&from, &config, &settings, &what.wind));
    windrow_jet_motor jet;
    WINDROW_AXES_OK(windrow_jet_motor_init(&jet, sizeof jet));
    jet.position = host.place(0.0, 2.0, 1.0);
    jet.direction = host.vector(1.0, 0.5, -0.25, 0);
    WINDROW_AXES_OK(windrow_wind_add_jet(what.wind, &jet, nullptr));
    WINDROW_AXES_OK(windrow_vulkan_frame_init(&what.frame, sizeof what.frame));
    WINDROW_AXES_OK(windrow_diagnostics_init(&what.report, sizeof what.report));
    WINDROW_AXES_OK(windrow_advance_init(&what.advance, sizeof what.advance));
    const windrow_dvec3 around = host.place(1.0, 2.0, -1.0);
    what.frame.around = &around;
    what.frame.slot = 0;
    for (int n = 0; n < 3; ++n) {
        what.ticks = n == 1;
        what.frame.dt = what.ticks ? 0.125 : 0.0625;
        what.frame.save = n == 2;
        WINDROW_AXES_OK(windrow_vulkan_device_run(device, record_commands, &what));
        WINDROW_AXES_OK(what.result);
        (void)windrow_vulkan_wind_collect(what.wind, 0);
    }
    windrow_vec3 velocity{};
    WINDROW_AXES_OK(windrow_wind_velocity(what.wind, host.place(1.5, 2.25, -0.75), &velocity));
    record.vector("velocity on the device", velocity, 1);
    WINDROW_AXES_OK(windrow_diagnostics_init(&what.report, sizeof what.report));
    WINDROW_AXES_OK(windrow_vulkan_wind_reported(what.wind, &what.report));
    record.number("max_speed", static_cast<double>(what.report.max_speed), 1);
    windrow_bytes* saved = nullptr;
    WINDROW_AXES_OK(windrow_vulkan_wind_saved(what.wind, &saved));
    windrow_wind* loaded = nullptr;
    WINDROW_AXES_OK(windrow_vulkan_wind_load(&from, windrow_bytes_data(saved), windrow_bytes_size(saved), &settings, &loaded));
    record.vector("ambient", windrow_wind_ambient(loaded), 1);
    windrow_bytes_destroy(saved);
    windrow_wind_destroy(loaded);
    windrow_wind_destroy(what.wind);
    // Inside a wind on the CPU.
    windrow_wind *outer = nullptr, *large = nullptr;
    config.cells = host.cells(16, 8, 14);
    config.cell_size = host.single(2.0);
    WINDROW_AXES_OK(windrow_wind_create(&config, &outer));
    WINDROW_AXES_OK(windrow_wind_add_jet(outer, &jet, nullptr));
    WINDROW_AXES_OK(windrow_wind_step(outer, 0.25, nullptr));
    config.cells = host.cells(16, 8, 12);
    config.cell_size = host.single(1.0);
    config.ambient = {};
    std::uint64_t alone = 0;
    WINDROW_AXES_OK(windrow_vulkan_wind_required_bytes(&from, &config, &settings, &alone, &reserved));
    WINDROW_AXES_OK(windrow_vulkan_wind_required_bytes_inside(&from, &config, &settings, outer, &memory, &reserved));
    EXPECT_GE(memory, alone + 32u * 16u * 8u * 12u); // for each cell of the box, and of its halo
    record.number("memory inside", static_cast<double>(memory));
    WINDROW_AXES_OK(windrow_vulkan_wind_create_inside(&from, &config, &settings, outer, &what.wind));
    what.ticks = false;
    what.frame.dt = 0.0625;
    what.frame.save = 1;
    WINDROW_AXES_OK(windrow_vulkan_device_run(device, record_commands, &what));
    WINDROW_AXES_OK(what.result);
    (void)windrow_vulkan_wind_collect(what.wind, 0);
    WINDROW_AXES_OK(windrow_wind_velocity(what.wind, host.place(-4.5, 2.25, -0.75), &velocity));
    record.vector("velocity inside", velocity, 1);
    WINDROW_AXES_OK(windrow_vulkan_wind_saved(what.wind, &saved));
    WINDROW_AXES_OK(
        windrow_vulkan_wind_load_inside(&from, windrow_bytes_data(saved), windrow_bytes_size(saved), &settings, outer, &large));
    windrow_bytes_destroy(saved);
    EXPECT_EQ(windrow_vulkan_wind_create_inside(&from, &config, &settings, large, &loaded), WINDROW_UNSUPPORTED);
    windrow_wind_destroy(outer);
    windrow_wind_destroy(large);
    windrow_wind_destroy(what.wind);
    if (!windrow_has_part(WINDROW_PART_COUPLING))
        return;
    windrow_ground_config remembered;
    WINDROW_AXES_OK(windrow_ground_config_init(&remembered, sizeof remembered));
    remembered.texels = 32;
    WINDROW_AXES_OK(windrow_vulkan_ground_create(&from, &remembered, WINDROW_TEXEL_FLOAT, &what.ground));
    WINDROW_AXES_OK(windrow_vulkan_ground_follow(what.ground, host.place(3.0, 0.0, -2.0)));
    WINDROW_AXES_OK(windrow_vulkan_ground_shift_origin(what.ground, host.place(4.0, 0.0, 8.0)));
    WINDROW_AXES_OK(windrow_ground_step_init(&what.step, sizeof what.step));
    what.step.duration = 0.0625;
    what.step.wind_lean = host.level(0.25, -0.125, 0);
    WINDROW_AXES_OK(windrow_vulkan_device_run(device, record_commands, &what));
    WINDROW_AXES_OK(what.result);
    windrow_ground_block block;
    WINDROW_AXES_OK(windrow_vulkan_ground_block(what.ground, host.place(1.0, 0.0, 0.5), &block));
    record.bytes(&block, sizeof block);
    windrow_ground_place_block place;
    WINDROW_AXES_OK(windrow_vulkan_ground_next_place(what.ground, host.place(1.0, 0.0, 0.5), &place));
    record.bytes(&place, sizeof place);
    windrow_vulkan_ground_destroy(what.ground);
}

TEST(AxesInC, AWindOnADeviceIsTheSame) {
    windrow_vulkan_device_settings settings;
    if (!windrow_has_part(WINDROW_PART_VULKAN))
        GTEST_SKIP();
    WINDROW_AXES_OK(windrow_vulkan_device_settings_init(&settings, sizeof settings));
    windrow_vulkan_device* device = nullptr;
    if (windrow_vulkan_device_create(&settings, &device) != WINDROW_OK)
        GTEST_SKIP() << windrow_last_error();
    windrow_vulkan_host from;
    WINDROW_AXES_OK(windrow_vulkan_host_init(&from, sizeof from));
    WINDROW_AXES_OK(windrow_vulkan_device_host(device, 0, &from));
    windrow_vulkan_pipeline_store* store = nullptr;
    WINDROW_AXES_OK(windrow_vulkan_pipeline_store_create(&from, &store));
    from.pipeline_store = store;
    expect_same_for_all_hosts([&](const Host& host, Record& record) { device_story(host, record, device, from); });
    windrow_vulkan_pipeline_store_destroy(store);
    windrow_vulkan_device_destroy(device);
}

} // namespace
