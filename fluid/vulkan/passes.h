// The passes of a tick: pipelines with their bindings and work group counts.
#pragma once

#include "fluid/api.h"
#include "fluid/operators.h"
#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/fields.h"
#include "fluid/vulkan/tables.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace windrow::vulkan {

enum class Pass : std::uint8_t {
    place,           ///< values for cells that the box exposes
    sources,         ///< motors, guard, reduction
    source_flow,     ///< what a solve for the sources of air gave
    adjust,          ///< adds a wind to the air
    plan,            ///< chooses the sub-steps
    limit,           ///< cuts speeds
    diffuse,         ///< viscosity, one explicit pass, ...
    diffuse_forward, ///< ... or a direct solve a component
    diffuse_columns,
    diffuse_back,
    stress,           ///< of rough ground, in columns
    pad,              ///< gathers what the advection reads
    advect,           ///< trajectories and interpolation, ...
    advect_one_sided, ///< ... or those that stop at sub-grid bodies
    modes_forward,    ///< the direct solve: right-hand side to modes, ...
    modes_between,    ///< ... the second axis where a plane does not fit in shared memory, ...
    columns,          ///< ... the systems along y, ...
    modes_back,       ///< ... and back to cells
    lines_forward,    ///< the same where lines and slabs fit in shared memory: to modes of x, ...
    slabs,            ///< ... z, y and z back at once, ...
    lines_back,       ///< ... and back to cells
    residual,         ///< what the first direct solve leaves around obstacles, ...
    surface,          ///< ... and how far to go along a further one
    level,            ///< ... and, last, the pressure in sealed air relative to none
    gradient,         ///< what a sub-step ends with
    rooms,            ///< closed rooms: what the wind, sources and rounding would blow there
    uncover,          ///< what obstacles leave that are to be placed again
    terms,            ///< the pressure's history at the faces of obstacles that were placed again
    loads,            ///< forces on obstacles
    lift,             ///< a box with rows of its own that has risen
    show,             ///< textures, and the sums of the report
    report,           ///< the report to the host
    read_cells,       ///< cells to the host, ...
    read_points,      ///< ... or the wind at points
    count
};
/// Most direct solves of a sub-step around obstacles: Config::pressure_solves.
inline constexpr std::uint32_t k_max_solves = 64;
/// Most dispatches of a sub-step: three solves of diffusion, in five each, those of pressure in six, and eight more.
inline constexpr std::uint32_t k_max_stages = 3 * 5 + 6 * k_max_solves + 8;
inline constexpr std::size_t k_passes = static_cast<std::size_t>(Pass::count);
/// The passes that write for the host: all of a read-back.
[[nodiscard]] constexpr bool reads_back(Pass pass) {
    return pass == Pass::report || pass == Pass::read_cells || pass == Pass::read_points;
}
/// As above: "modes_forward".
[[nodiscard]] WINDROW_INTERNAL const char* name_of(Pass pass);

/// Push constants of any pass: one of the structs for them in blocks.glsl.
class Push {
  public:
    Push() = default;
    template <class Content>
    Push(const Content& content) {
        static_assert(sizeof(Content) <= sizeof(words_) && std::is_trivially_copyable_v<Content>);
        std::memcpy(words_.data(), &content, sizeof(Content));
    }
    /// The same with the number of a sub-step, which the structs of its passes begin with.
    [[nodiscard]] Push in_substep(std::int32_t substep) const {
        Push push = *this;
        push.words_[0] = substep;
        return push;
    }

  private:
    std::array<std::int32_t, 9> words_{};
};

class Passes {
  public:
    struct Settings {
        glm::ivec3 cells{0};
        bool projects = true;
        Texel texel = Texel::half;
        TextureSet textures = TextureSet::vectors;
        glm::ivec3 read_cells{0}; ///< box of cells that come back to the host; 0: none
        bool read_halves = false; ///< as halves, else floats
        bool obstacles = false;   ///< else the passes know none
        bool rough = false;       ///< over rough ground
        bool rows = false;        ///< of unequal thickness
        bool outer = false;       ///< the box is in an outer wind
        bool samples = false;     ///< cells beside surfaces are shown otherwise than they are
    };
    [[nodiscard]] static Result<Passes> create(Device& device, const Fields& fields, const Settings& settings);
    /// Sets the tables of the direct solve; call it before the first sub-step.
    void set_tables(const SolveTables& tables);
    /// Whether the direct solve of such a box can run in slabs: x and z of a multiple of 8 cells, of which a line and half a slab of
    /// constant x fit in 16 KiB of shared memory. Where ends are unlike, the planes' passes run all the same.
    [[nodiscard]] static bool fits_in_slabs(const Device& device, glm::ivec3 cells);
    /// Number of work groups of cells: the entries of Fields::sums.
    [[nodiscard]] static std::uint32_t sums(const Device& device, glm::ivec3 cells);
    /// Most dispatches that the plan commands in a tick of `substeps`: those of all but the first.
    [[nodiscard]] static std::uint32_t commands(int substeps) {
        return std::max(1u, k_max_stages * static_cast<std::uint32_t>(substeps - 1));
    }

    using Groups = std::array<std::uint32_t, 3>;
    /// They know of cells that are shown otherwise than they are.
    [[nodiscard]] bool sample() const { return settings_.samples; }
    [[nodiscard]] Groups groups(Pass pass) const { return groups_[static_cast<std::size_t>(pass)]; }
    /// [bytes] What a dispatch of all its work groups moves where every field that it binds holds something: each field of cells
    /// that it binds, once if it reads or writes it and twice for both, and its textures. Left out are the tables, the rules, the
    /// motors and the gust tile, which stay in caches, and the drag of deposits, which is a stand-in at first. A pass that finds a
    /// field empty, as where no air is let in, moves less.
    [[nodiscard]] std::uint64_t bytes(Pass pass) const { return bytes_[static_cast<std::size_t>(pass)]; }
    /// One dispatch of a sub-step: the pass and its push constants without the sub-step's number.
    struct Stage {
        Pass pass;
        Push push;
    };
    /// What a sub-step does for obstacles.
    struct Around {
        int solves = 0; ///< of the pressure; 0: there are none
        bool one_sided = false, rooms = false, sealed = false, loads = false;
        bool first_sources = false; ///< of air that was filled since it had any
        friend bool operator==(const Around&, const Around&) = default;
    };
    /// A sub-step, in order, with as much diffusion as it may come to.
    [[nodiscard]] std::span<const Stage> substep(DiffusionMethod most) const { return substeps_[static_cast<std::size_t>(most)]; }
    /// The direct solve for the sources of air, in order.
    [[nodiscard]] std::span<const Stage> source_solve() const { return source_solve_; }
    /// The same around obstacles. Good until the next call of either.
    [[nodiscard]] std::span<const Stage> substep(DiffusionMethod most, const Around& around);
    [[nodiscard]] std::span<const Stage> source_solve(const Around& around);
    /// Contents of Fields::shapes: number of passes of a sub-step, and the work groups of each. Good until the next call.
    [[nodiscard]] std::span<const std::uint32_t> shapes(std::span<const Stage> substep);

    /// Offsets of the blocks in Fields::step and Fields::motors that the passes recorded from now on read.
    struct Blocks {
        std::uint32_t step = 0, motors = 0;
    };
    void use(const Blocks& blocks) { blocks_ = blocks; }
    /// Records a pass; barriers are the caller's. `set`: entry of Fields::slots for the passes that the host reads; for
    /// Pass::show that, and behind all of these those of the second textures.
    void record(VkCommandBuffer commands, Pass pass, const Push& push, int set = 0) const;
    /// The same with work groups from Fields::commands, entry `n`.
    void record_indirect(VkCommandBuffer commands, Pass pass, const Push& push, std::uint32_t n) const;
    /// Binds the fields' buffers that there are now. Returns the old sets, which recordings in flight may use.
    [[nodiscard]] Result<Sets> rebind(Device& device, const Fields& fields);

  private:
    /// What a pass binds: buffers of the fields, the last one a slot of the host's, or textures behind them.
    struct Bound {
        Pass pass;
        std::vector<const Buffer*> buffers;
        bool to_host;
    };
    /// A direct solve: forward, columns, back, with the second axis between where it has passes of its own.
    struct Solve {
        Pass forward, columns, back;
        Push columns_push;
        int part;
        int number = 0; ///< around obstacles
    };

    void bind(VkCommandBuffer commands, Pass pass, const Push& push, int set) const;
    [[nodiscard]] Result<Sets> sets_of(Device& device, const Fields& fields);
    void add_solve(std::vector<Stage>& stages, const Solve& solve, const SolveTables::Vectors& at) const;
    void add_pressure(std::vector<Stage>& stages, int part, const Around& around) const;
    void add_substep(std::vector<Stage>& stages, DiffusionMethod most, const Around& around) const;

    const Functions* functions_ = nullptr;
    VkBuffer commands_ = VK_NULL_HANDLE;
    std::array<std::shared_ptr<const Pipeline>, k_passes>
        pipelines_; ///< of this wind, or shared with others (Host::pipeline_store)
    std::array<std::size_t, k_passes> first_set_{};
    std::array<Groups, k_passes> groups_{};
    std::array<std::uint64_t, k_passes> bytes_{};
    std::array<bool, k_passes> binds_motors_{};
    Blocks blocks_;
    Sets sets_;
    Settings settings_;
    bool whole_planes_ = true, in_slabs_ = false;
    std::vector<Bound> bound_;
    SolveTables::Vectors pressure_, diffusion_[3];
    Push pressure_columns_, pressure_slabs_, diffusion_columns_[3];
    std::vector<Stage> substeps_[3], source_solve_, around_; ///< without obstacles; scratch for those around them
    std::vector<std::uint32_t> shapes_;                      ///< scratch
};

} // namespace windrow::vulkan
