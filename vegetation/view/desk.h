// What lies before the person at the window: the session, the eye, what is chosen, and the panels that change them.
#pragma once

#include "fluid/debug_draw.h"
#include "vegetation/view/eye.h"
#include "vegetation/view/session.h"
#include "vegetation/view/slice.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace windrow::vegetation::view {

/// Something that has a handle.
struct Choice {
    enum class Kind { nothing, motor, obstacle } kind = Kind::nothing;
    std::size_t place = 0; ///< in Session::motors or obstacles
    friend bool operator==(const Choice&, const Choice&) = default;
};

/// The last values of a figure, for its graph.
class Graph {
  public:
    void add(double value) {
        values_[next_] = static_cast<float>(value);
        next_ = (next_ + 1) % values_.size();
    }
    void draw(const char* name, const char* unit) const;
    [[nodiscard]] float last() const { return values_[(next_ + values_.size() - 1) % values_.size()]; }

  private:
    std::array<float, 240> values_{};
    std::size_t next_ = 0;
};

struct Figures {
    Graph speed{}, cfl{}, energy{}, step_ms{}, frame_ms{}, cpu_ms{}, device_ms{};
};

enum class Tool { choose, gust, press, comb, blow, paint, erase };
/// Its names, in that order, and what each does.
struct ToolName {
    const char* name;
    const char* said; ///< when it is taken
    const char* meaning;
};
[[nodiscard]] const ToolName& name_of(Tool tool);
inline constexpr int k_tools = 7;

/// Added to a key that was pressed with Control.
inline constexpr int k_control = 1 << 16;

/// A film that is being kept: each frame as a picture.
struct Filming {
    std::filesystem::path folder{};
    std::int64_t frames = 0;
};

struct Desk {
    explicit Desk(Session& its_session);

    Session& session;
    Eye eye;
    DebugDraw overlay{.box = true, .motors = true, .obstacles = false};
    program::Show show = program::Show::plants;
    std::function<void(const std::string&)> say{};
    std::vector<int> keys{}; ///< GLFW's, pressed since the frame before: one that is up again counts too
    bool panel = true, playing = true, closes = false;
    double rate = 1.0; ///< of the clock
    Choice chosen{}, dragged{};
    glm::dvec3 grab{0.0}; ///< [m] from the pointer's place to what is dragged
    Tool tool = Tool::choose;
    std::optional<glm::dvec3> gust_from{};
    float brush = 0.6f;              ///< [m] radius of the hand
    int layer = 0;                   ///< that is painted
    std::optional<glm::dvec3> dab{}; ///< the last of a stroke of the brush
    SliceOf slice_of = SliceOf::nothing;
    Slice slice{};
    std::optional<Session::Difference> difference{}; ///< of both solvers
    std::string fault{};                             ///< of the last change; empty: none
    std::string scene_file{}, picture_file{}, fields_file{}, vdb_file{}, cpp_file{}, log_folder{}, film_file{};
    /// Writes the air as a VDB; empty: the build has none.
    std::function<Result<void>(const std::filesystem::path& file, const WindControl& control, const WindReader& reader)>
        write_vdb{};
    bool wants_picture = false;
    std::optional<Filming> filming{};
    Figures figures{};
    std::string device{}; ///< its name, and the look

    /// Keeps the sentence of a change that was rejected.
    bool done(const Result<void>& result);
    /// A line for people and scripts: `say`, with the scene's time.
    void tell(const std::string& what);
    [[nodiscard]] render::Camera camera() const;
    /// Where the ground or the box's floor is.
    [[nodiscard]] double ground(double x, double z) const;

    void add_house(glm::dvec3 foot);
    void add_fan(glm::dvec3 foot);
    void remove_chosen();
    void save_field();
    void save_vdb();
    void save_cpp();
    void save_log();
    void take(Tool chosen_tool);
    void cut(SliceOf what);
    void set_solver(program::Backend backend);
    void compare();
    void begin_film();
    void end_film();
};

/// The panels. ImGui has a frame begun.
void draw_panels(Desk& desk);
/// Lines and handles over the picture, and what the pointer does to them and to the eye.
void draw_overlay(Desk& desk);
void use_pointer(Desk& desk);
/// Keys, and a gamepad where one is; `seconds` since the frame before.
void use_keys(Desk& desk, double seconds);
/// All handles with their pixels, a line each.
[[nodiscard]] std::string handles_text(const Desk& desk);

} // namespace windrow::vegetation::view
