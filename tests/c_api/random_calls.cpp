// Random calls of the whole C interface: every function of the headers that needs no device, with any numbers, null pointers, handles
// that name nothing, own snapshots and damaged ones. windrow_random_calls FOLDER [CALLS] [SEED], 20000 and 1.
// Each story begins with a few small objects, makes 400 calls and lets all go. What holds: nothing ends the process; no call is answered
// with WINDROW_UNEXPECTED; one that fails says why and leaves the wind as it was; and a wind is whole again after ten steps, whatever
// was set or loaded: its air is finite, and its own bytes are accepted.
#include "fluid/core/bytes.h"
#include "tests/c_api/random_world.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unistd.h>
#include <vector>
#include <windrow/windrow.h>

#ifdef __SANITIZE_ADDRESS__
extern "C" void __sanitizer_set_death_callback(void (*)());
#endif

namespace windrow::test {

constexpr int k_calls_a_story = 400;
// Where the process ends, it says in which call.
char g_where[200] = "before the first call\n";
long g_inside = 0; // winds that were loaded again inside another

void say_where() {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, g_where, std::strlen(g_where));
}

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "%s\n", what.c_str());
    std::abort();
}

void run_backward(void* /*context*/, std::int32_t count, windrow_task task, void* argument) {
    for (std::int32_t i = count - 1; i >= 0; --i)
        task(argument, i);
}

std::uint64_t texels_of(const windrow_ground* ground) {
    std::uint64_t count = 0;
    (void)windrow_ground_texels(ground, &count);
    return count;
}

std::uint64_t product(windrow_ivec3 cells) {
    return cells.x > 0 && cells.y > 0 && cells.z > 0 && cells.x < 64 && cells.y < 64 && cells.z < 64
               ? static_cast<std::uint64_t>(cells.x * cells.y * cells.z)
               : 0;
}

std::uint64_t product(windrow_ivec2 corners) {
    return product(windrow_ivec3{corners.x, corners.y, 1});
}

struct Call {
    const char* name;
    void (*make)(World&);
};

std::uint64_t cells_of(const windrow_wind* wind) {
    return windrow_wind_cell_count(wind);
}

std::uint64_t cells_in(const windrow_workspace* work) {
    return windrow_workspace_cell_count(work);
}

std::uint64_t entries_of(const windrow_skin* skin) {
    return skin != nullptr ? skin->count : 0;
}

#include "calls.inc"

// --- Structs whose pointers have a measure of their own

void fill(World& world, windrow_parallel_for& loop) {
    loop = {world.one_in(2) ? nullptr : &run_backward, nullptr};
    if (windrow_thread_pool* const pool = world.handle<windrow_thread_pool>(); pool != nullptr && world.one_in(3))
        loop = windrow_thread_pool_parallel_for(pool);
}

void fill(World& world, windrow_spring_batch& batch) {
    batch.count = world.count(0);
    for (void** const array :
         {&batch.place, &batch.velocity, &batch.place_remainder, &batch.velocity_remainder, &batch.place_previous})
        *array = world.array<double>(batch.count);
    for (const void** const array : {&batch.target_before, &batch.target_now})
        *array = world.array<double>(batch.count);
}

void fill(World& world, windrow_cascade_batch& batch) {
    batch.rows = world.count(0);
    batch.value = world.array<double>(64 * batch.rows); // stages are tamed to 64
    batch.remainder = world.one_in(2) ? world.array<double>(64 * batch.rows) : nullptr;
    batch.body_before = world.array<double>(batch.rows);
    batch.body_now = world.array<double>(batch.rows);
}

void fill(World& world, windrow_skin& skin) {
    skin = {world.count(0), nullptr, nullptr};
    skin.positions = world.array<windrow_vec4>(skin.count);
    skin.normals = world.array<windrow_vec4>(skin.count);
}

void fill(World& world, windrow_ground_step& step) {
    (void)windrow_ground_step_init(&step, sizeof step);
    world.put(step.wind_lean);
    world.number(step.duration, "duration");
    step.walker_count = world.count(0);
    step.walkers = world.array<windrow_ground_walker>(step.walker_count);
}

void fill(World& world, windrow_query& query) {
    (void)windrow_query_init(&query, sizeof query);
    world.choose(query.frame, {0, 1});
    query.count = world.count(0);
    world.choose(query.number, {0, 1});
    query.position_stride = world.one_in(2) ? 0 : 32;
    query.positions = world.array<windrow_dvec4>(query.count);
    world.put(query.anchor);
    query.velocity_stride = world.one_in(2) ? 0 : 16;
    query.velocities = world.array<float>(4 * query.count);
    query.sampling = world.maybe<windrow_sampling>();
}

void fill(World& world, windrow_rows& rows) {
    (void)windrow_rows_init(&rows, sizeof rows);
    world.number(rows.first, "first");
    world.number(rows.uniform, "uniform");
    world.number(rows.ratio, "ratio");
    world.number(rows.top, "top");
    rows.height_count = world.one_in(2) ? 0 : static_cast<std::uint32_t>(world.count(0));
    rows.heights = world.array<float>(rows.height_count);
}

// As many as the largest box of a story has cells: the structs of files do not count them.
constexpr std::uint64_t k_values = 12 * 12 * 12;

void fill(World& world, windrow_transport& transport) {
    (void)windrow_transport_init(&transport, sizeof transport);
    world.number(transport.dt, "dt");
    transport.carried = world.array<windrow_vec4>(k_values);
    transport.velocity = world.one_in(4) ? transport.carried : world.array<windrow_vec4>(k_values);
    transport.velocity_old = world.one_in(2) ? nullptr : world.array<windrow_vec4>(k_values);
    transport.history = world.one_in(2) ? nullptr : world.array<windrow_vec4>(k_values);
    for (float* const number : {&transport.history_scale, &transport.extrapolation, &transport.relaxation})
        if (world.changes())
            world.number(*number, "");
    world.choose(transport.interpolation, {0, 1});
}

void fill(World& world, windrow_scalar_transport& transport) {
    (void)windrow_scalar_transport_init(&transport, sizeof transport);
    world.number(transport.dt, "dt");
    transport.carried = world.array<float>(k_values);
    transport.velocity = world.array<windrow_vec4>(k_values);
    world.number(transport.outside, "outside");
    transport.clamped = world.one_in(2);
    world.choose(transport.interpolation, {0, 1});
}

void fill(World& world, windrow_vdb_scalar& grid) {
    grid = {world.text(), world.text(), world.array<float>(k_values), 0.0f, 0};
}

void fill(World& world, windrow_vdb_vector& grid) {
    grid = {world.text(), world.text(), world.array<windrow_vec4>(k_values)};
}

void fill(World& world, windrow_vdb_film& film) {
    (void)windrow_vdb_film_init(&film, sizeof film);
    if (world.changes())
        world.number(film.margin, "margin");
    film.scalar_count = world.one_in(2) ? 0 : 1;
    film.scalars = world.array<windrow_vdb_scalar>(film.scalar_count);
}

void fill(World& world, windrow_vdb_grid& grid) {
    (void)windrow_vdb_grid_init(&grid, sizeof grid);
    world.put(grid.cells);
    grid.count = world.count(product(grid.cells));
    grid.field = world.array<windrow_vec4>(grid.count);
    grid.obstacle = world.one_in(2) ? nullptr : world.array<float>(grid.count);
    world.number(grid.cell_size, "cell_size");
    grid.scalar_count = world.one_in(2) ? 0 : 1;
    grid.scalars = world.array<windrow_vdb_scalar>(grid.scalar_count);
    grid.vector_count = world.one_in(2) ? 0 : 1;
    grid.vectors = world.array<windrow_vdb_vector>(grid.vector_count);
}

void fill(World& world, windrow_saved_part& part) {
    part.name = world.text();
    part.bytes = world.bytes(part.size);
}

void fill(World& world, windrow_motor_id& id) {
    world.any_id(id, world.motors());
}
void fill(World& world, windrow_drag_id& id) {
    world.any_id(id, world.deposits());
}
void fill(World& world, windrow_obstacle_id& id) {
    world.any_id(id, world.obstacles());
}

// --- World

template <class Number>
void World::number(Number& value, std::string_view name) {
    if constexpr (std::is_floating_point_v<Number>) {
        using Limits = std::numeric_limits<Number>;
        const Number odd[] = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Number(1e30),
                              Number(-1e30),       Limits::max(),      Limits::lowest(),    Limits::denorm_min()};
        const Number plain[] = {0, 1, -1, Number(.5), 2, 10};
        const int kind = random_.integer(0, 19);
        if (kind == 0)
            value = odd[random_.integer(0, 7)];
        else if (kind < 8)
            value = plain[random_.integer(0, 5)];
        else
            value = static_cast<Number>((one_in(4) ? -1.0 : 1.0) * random_.spread(1e-3, kind == 19 ? 1e6 : 20.0));
    } else if (name.starts_with("reserved"))
        value = one_in(20) ? 1 : 0;
    else if (one_in(30))
        value = one_in(2) ? std::numeric_limits<Number>::max() : std::numeric_limits<Number>::min();
    else if constexpr (sizeof(Number) < 4)
        value = static_cast<Number>(random_.bits());
    else
        value = static_cast<Number>(random_.integer(std::is_signed_v<Number> ? -1 : 0, 12));
    if (name == "stages" && value > 64) // of a cascade; a config's is a set of bits
        value = 64;
}

template <class Kind>
void World::put(Kind& value) {
    if constexpr (std::is_arithmetic_v<Kind>)
        number(value, "");
    else
        fill(*this, value);
}

template <class Struct>
void World::tame(Struct& value) {
    if constexpr (std::is_same_v<Struct, windrow_ivec3>) {
        for (std::int32_t* const n : {&value.x, &value.y, &value.z})
            *n = *n > 12 && one_in(8) ? *n : std::min(*n, 12); // too many cells are rejected, or too many for the time
        if (std::max({value.x, value.y, value.z}) > 12 && std::max({value.x, value.y, value.z}) <= 2048)
            value = {8, 8, 8};
    }
    if constexpr (std::is_same_v<Struct, windrow_config>) {
        if (value.cells.x == 32)
            value.cells = {10, 6, 8};
        value.pressure_solves = std::min(value.pressure_solves, 6);
        value.max_substeps = std::min(value.max_substeps, 6);
        value.ticks_max_per_call = std::min(value.ticks_max_per_call, 4);
    }
    if constexpr (std::is_same_v<Struct, windrow_ground_config>)
        value.texels = std::min(value.texels, 64);
}

const char* World::text() {
    const std::string good = (folder_ / ("a" + std::to_string(random_.integer(0, 3)) + ".vdb")).string();
    const std::string texts[] = {good, good, folder_.string(), "", "no/such/folder/a.vdb", "smoke", "1/s", "\xff\xfe", "a b\n"};
    const std::string& text = texts[random_.integer(0, 8)];
    char* const copy = zeroed<char>(text.size() + 1);
    std::memcpy(copy, text.data(), text.size());
    return one_in(20) ? nullptr : copy;
}

const void* World::bytes(std::uint64_t& size) {
    size = 0;
    if (saved_.empty())
        return nullptr;
    std::string data = saved_[random_.bits() % saved_.size()];
    loaded_ = true;
    constexpr std::size_t k_envelope = windrow::detail::k_header_bytes + windrow::detail::k_checksum_bytes;
    if (!one_in(3) && data.size() > k_envelope) { // damaged, and sealed again
        const std::size_t content = data.size() - k_envelope;
        for (int n = random_.integer(1, 3); n > 0; --n) {
            // Half of them near the begin, where settings lie and not cells.
            const std::size_t at =
                windrow::detail::k_header_bytes + random_.bits() % (one_in(2) ? content : std::min<std::size_t>(content, 600));
            data[at] = static_cast<char>(one_in(2) ? random_.bits() : data[at] ^ (1 << random_.integer(0, 7)));
        }
        if (!one_in(20)) {
            auto* const begin = reinterpret_cast<std::byte*>(data.data());
            const std::size_t sealed = data.size() - windrow::detail::k_checksum_bytes;
            windrow::detail::store_number(begin + sealed, windrow::detail::checksum({begin, sealed}));
        }
    }
    size = one_in(30) ? random_.bits() % data.size() : data.size();
    char* const copy = zeroed<char>(size);
    std::memcpy(copy, data.data(), size);
    return copy;
}

template <class Kind>
Kind* World::take() {
    auto& pool = std::get<std::vector<Kind*>>(pools_);
    if (pool.empty() || one_in(30))
        return nullptr;
    const std::size_t at = random_.bits() % pool.size();
    Kind* const taken = pool[at];
    pool.erase(pool.begin() + static_cast<std::ptrdiff_t>(at));
    if constexpr (std::is_same_v<Kind, windrow_event_log>)
        for (windrow_wind* const wind : std::get<std::vector<windrow_wind*>>(pools_))
            (void)windrow_wind_record_to(wind, nullptr);
    return taken;
}

template <class Kind>
void World::keep(Kind* made) {
    if (made == nullptr)
        return;
    if constexpr (std::is_same_v<Kind, windrow_bytes>) {
        const auto* const data = reinterpret_cast<const char*>(windrow_bytes_data(made));
        std::string copy(data, windrow_bytes_size(made));
        if (saved_.size() < 12)
            saved_.push_back(std::move(copy));
        else
            saved_[random_.bits() % saved_.size()] = std::move(copy);
    }
    auto& pool = std::get<std::vector<Kind*>>(pools_);
    pool.push_back(made);
    if constexpr (std::is_same_v<Kind, windrow_wind>) {
        if (loaded_)
            must_heal(made);
        if (pool.size() > 4) { // a story of many winds is one of few steps
            windrow_wind_destroy(pool.front());
            pool.erase(pool.begin());
        }
    }
}

template <class Made>
void World::judge(windrow_wind* wind, const Made& call) {
    const bool compare = wind != nullptr && one_in(16);
    const std::string before = compare ? saved(wind) : std::string();
    const windrow_result result = call();
    worked_ = result == WINDROW_OK;
    if (result > WINDROW_OK || result < WINDROW_DEVICE_LOST || result == WINDROW_UNEXPECTED)
        fail("answered " + std::to_string(result) + ": " + windrow_last_error());
    if (!worked_ && *windrow_last_error() == '\0')
        fail("failed without a sentence");
    if (!worked_ && compare && saved(wind) != before)
        fail(std::string("failed, and changed the wind: ") + windrow_last_error());
}

std::string World::saved(windrow_wind* wind) {
    windrow_bytes* bytes = nullptr;
    if (windrow_wind_save(wind, &bytes) != WINDROW_OK)
        fail(std::string("a wind cannot be saved: ") + windrow_last_error());
    std::string copy(reinterpret_cast<const char*>(windrow_bytes_data(bytes)), windrow_bytes_size(bytes));
    windrow_bytes_destroy(bytes);
    return copy;
}

void World::must_heal(windrow_wind* wind) {
    for (int n = 0; n < 10; ++n)
        if (windrow_wind_step(wind, 1.0 / 60.0, nullptr) != WINDROW_OK)
            fail(std::string("a step: ") + windrow_last_error());
    const windrow_vec4* cells = nullptr;
    std::uint64_t count = 0;
    if (windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, nullptr) != WINDROW_OK)
        fail(std::string("the field: ") + windrow_last_error());
    for (std::uint64_t i = 0; i < count; ++i)
        if (!std::isfinite(cells[i].x) || !std::isfinite(cells[i].y) || !std::isfinite(cells[i].z))
            fail("air that is no number after ten steps");
    const std::string bytes = saved(wind);
    windrow_wind* again = nullptr;
    bool own = windrow_wind_load(bytes.data(), bytes.size(), {}, &again) == WINDROW_OK;
    const bool inside = !own && std::strstr(windrow_last_error(), "saved with an outer wind");
    for (windrow_wind* const around : std::get<std::vector<windrow_wind*>>(pools_))
        if (inside && !own) // that one, or the one around has ended
            own = windrow_wind_load_inside(bytes.data(), bytes.size(), {}, around, &again) == WINDROW_OK;
    g_inside += inside && own;
    if (!own && !inside)
        fail(std::string("own bytes are rejected: ") + windrow_last_error());
    windrow_wind_destroy(again);
}

World::~World() {
    begin_call();
    for (windrow_wind* const wind : std::get<std::vector<windrow_wind*>>(pools_))
        must_heal(wind);
    const auto all = [this](auto destroy, auto* none) {
        for (auto* const object : std::get<std::vector<decltype(none)>>(pools_))
            destroy(object);
    };
    all(&windrow_tracer_destroy, static_cast<windrow_tracer*>(nullptr));
    all(&windrow_ground_destroy, static_cast<windrow_ground*>(nullptr));
    all(&windrow_wind_destroy, static_cast<windrow_wind*>(nullptr));
    all(&windrow_scene_destroy, static_cast<windrow_scene*>(nullptr));
    all(&windrow_workspace_destroy, static_cast<windrow_workspace*>(nullptr));
    all(&windrow_ambient_wind_destroy, static_cast<windrow_ambient_wind*>(nullptr));
    all(&windrow_event_log_destroy, static_cast<windrow_event_log*>(nullptr));
    all(&windrow_bytes_destroy, static_cast<windrow_bytes*>(nullptr));
    all(&windrow_cascade_destroy, static_cast<windrow_cascade*>(nullptr));
    all(&windrow_cascade_step_destroy, static_cast<windrow_cascade_step*>(nullptr));
    all(&windrow_blades_destroy, static_cast<windrow_blades*>(nullptr));
    all(&windrow_shells_destroy, static_cast<windrow_shells*>(nullptr));
    all(&windrow_tree_destroy, static_cast<windrow_tree*>(nullptr));
    all(&windrow_gust_tile_destroy, static_cast<windrow_gust_tile*>(nullptr));
    all(&windrow_mesh_destroy, static_cast<windrow_mesh*>(nullptr));
    all(&windrow_voxels_destroy, static_cast<windrow_voxels*>(nullptr));
    all(&windrow_height_map_destroy, static_cast<windrow_height_map*>(nullptr));
    all(&windrow_thread_pool_destroy, static_cast<windrow_thread_pool*>(nullptr));
}

/// Heavy ones are rare: a tile takes milliseconds to bake.
bool is_skipped(const char* name, World& world) {
    return std::string_view(name) == "windrow_gust_tile_bake" && !world.one_in(20);
}

} // namespace windrow::test

int main(int count, char** arguments) {
    using namespace windrow::test;
    if (count < 2) {
        std::fprintf(stderr, "usage: %s FOLDER [CALLS] [SEED]\n", arguments[0]);
        return 2;
    }
#ifdef __SANITIZE_ADDRESS__
    __sanitizer_set_death_callback(&say_where);
#else
    std::signal(SIGSEGV, [](int) { say_where(), std::_Exit(139); });
    std::signal(SIGFPE, [](int) { say_where(), std::_Exit(136); });
#endif
    std::signal(SIGABRT, [](int) { say_where(), std::_Exit(134); });
    const std::filesystem::path folder = std::filesystem::absolute(arguments[1]);
    std::filesystem::create_directories(folder);
    std::filesystem::current_path(folder); // files whose path is any text
    const int calls = count > 2 ? std::atoi(arguments[2]) : 20'000;
    const auto first = static_cast<std::uint32_t>(count > 3 ? std::atoi(arguments[3]) : 1);
    long made = 0, good = 0;
    for (std::uint32_t seed = first; made < calls; ++seed) {
        World world(seed, folder);
        world.begin();
        Random random(seed + 1'000'000'007u);
        for (int n = 0; n < k_calls_a_story; ++n) {
            const Call& call = k_calls[random.bits() % std::size(k_calls)];
            if (is_skipped(call.name, world))
                continue;
            std::snprintf(g_where, sizeof g_where, "in call %d of the story %u: %s\n", n, seed, call.name);
            world.begin_call();
            call.make(world);
            ++made;
            good += world.worked();
        }
        std::snprintf(g_where, sizeof g_where, "at the end of the story %u\n", seed);
    }
    std::printf("%ld calls, %ld of them with a result that worked, %ld winds loaded inside another\n", made, good, g_inside);
    return calls < 20'000 || g_inside > 0 ? 0 : 1;
}
