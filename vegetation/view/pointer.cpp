#include "fluid/core/message.h"
#include "vegetation/view/desk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <imgui.h>
#include <numbers>
#include <utility>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr float k_reach = 12.0f; // [px] of a handle
constexpr ImU32 k_plain = IM_COL32(255, 190, 60, 230), k_lit = IM_COL32(255, 255, 255, 255), k_dim = IM_COL32(255, 190, 60, 90);

Projection projection_of(const Desk& desk) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    return {desk.camera(), {size.x, size.y}};
}

struct Held {
    Choice choice;
    const std::string* name;
    glm::dvec3 place;
};

/// All that has a handle.
std::vector<Held> held(const Desk& desk) {
    std::vector<Held> list;
    for (std::size_t n = 0; n < desk.session.motors().size(); ++n)
        if (const auto& motor = desk.session.motors()[n]; !motor.path && !desk.session.removed_motor(n))
            list.push_back({{Choice::Kind::motor, n}, &motor.name, position_of(motor.motor)});
    for (std::size_t n = 0; n < desk.session.obstacles().size(); ++n)
        if (const auto& body = desk.session.obstacles()[n];
            !body.path && desk.session.can_change_obstacle(n) && !desk.session.removed_obstacle(n))
            list.push_back({{Choice::Kind::obstacle, n}, &body.name, body.obstacle.position});
    return list;
}

std::optional<Held> nearest(const Desk& desk, const Projection& projection, glm::vec2 pointer) {
    std::optional<Held> best;
    float least = k_reach;
    for (const Held& one : held(desk))
        if (const auto pixel = projection.pixel(one.place); pixel && glm::distance(*pixel, pointer) < least) {
            least = glm::distance(*pixel, pointer);
            best = one;
        }
    return best;
}

glm::dvec3 place_of(const Desk& desk, const Choice& choice) {
    return choice.kind == Choice::Kind::motor ? position_of(desk.session.motors()[choice.place].motor)
                                              : desk.session.obstacles()[choice.place].obstacle.position;
}

void put(Desk& desk, const Choice& choice, glm::dvec3 place) {
    if (choice.kind == Choice::Kind::motor)
        (void)desk.done(desk.session.move_motor(choice.place, place));
    else
        (void)desk.done(
            desk.session.move_obstacle(choice.place, place, desk.session.obstacles()[choice.place].obstacle.orientation));
}

/// About the upright axis.
void turn_by(Desk& desk, const Choice& choice, float angle) {
    const glm::quat turn = glm::angleAxis(angle, glm::vec3(0.0f, 1.0f, 0.0f));
    if (choice.kind == Choice::Kind::obstacle) {
        const Obstacle& body = desk.session.obstacles()[choice.place].obstacle;
        (void)desk.done(desk.session.move_obstacle(choice.place, body.position, glm::normalize(turn * body.orientation)));
        return;
    }
    Motor motor = desk.session.motors()[choice.place].motor;
    std::visit(
        [&](auto& kind) {
            if constexpr (requires { kind.direction; })
                kind.direction = turn * kind.direction;
        },
        motor);
    (void)desk.done(desk.session.set_motor(choice.place, motor));
}

void drag(Desk& desk, const Projection& projection, glm::vec2 pointer) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl) {
        turn_by(desk, desk.dragged, 0.01f * io.MouseDelta.x);
        return;
    }
    glm::dvec3 place = place_of(desk, desk.dragged);
    if (io.KeyShift) {
        const double far = glm::distance(place, projection.eye());
        place.y -= static_cast<double>(io.MouseDelta.y) * far / static_cast<double>(io.DisplaySize.y);
        put(desk, desk.dragged, place);
    } else if (const auto level = projection.on_level(pointer, place.y)) {
        put(desk, desk.dragged, glm::dvec3(level->x, place.y, level->z) + desk.grab);
    }
}

/// Where the pointer's ray meets the ground, hills too.
std::optional<glm::dvec3> on_ground(const Desk& desk, const Projection& projection, glm::vec2 pointer) {
    const glm::dvec3 eye = projection.eye(), ray = projection.ray(pointer);
    const auto above = [&](double way) {
        const glm::dvec3 place = eye + way * ray;
        return place.y - desk.ground(place.x, place.z);
    };
    constexpr double k_farthest = 2000.0; // [m]
    double near = 0.0, far = 0.25;
    while (above(far) > 0.0) {
        near = far;
        far *= 1.05;
        if (far > k_farthest)
            return std::nullopt;
    }
    for (int n = 0; n < 30; ++n) {
        const double middle = 0.5 * (near + far);
        (above(middle) > 0.0 ? near : far) = middle;
    }
    return eye + far * ray;
}

bool strokes_grass(Tool tool) {
    return tool == Tool::press || tool == Tool::comb;
}

bool paints(Tool tool) {
    return tool == Tool::paint || tool == Tool::erase;
}

void dab(Desk& desk, glm::dvec3 place) {
    if (desk.dab && glm::distance(*desk.dab, place) < 0.5 * static_cast<double>(desk.brush))
        return;
    desk.dab = place;
    (void)desk.done(desk.session.paint(static_cast<std::size_t>(desk.layer), place, desk.brush, desk.tool == Tool::erase));
}

/// A button went down over the ground.
void begin_hand(Desk& desk, glm::dvec3 place) {
    if (desk.tool == Tool::gust) {
        desk.gust_from = place;
    } else if (strokes_grass(desk.tool)) {
        (void)desk.done(
            desk.session.begin_stroke(desk.tool == Tool::comb ? Session::Hand::comb : Session::Hand::press, place, desk.brush));
    } else if (paints(desk.tool)) {
        dab(desk, place);
    } else if (desk.tool == Tool::blow) {
        const auto added = desk.session.blast(place, 3.0f * desk.brush, 18.0f);
        if (desk.done(added ? Result<void>{} : added.failure()))
            desk.tell(message("blew ", desk.session.motors()[*added].name, " at ", place));
    }
}

/// While a button is down, and when it goes up.
void move_hand(Desk& desk, const Projection& projection, glm::vec2 pointer) {
    const auto place = on_ground(desk, projection, pointer);
    if (ImGui::GetIO().MouseDown[0]) {
        if (place && desk.dab)
            dab(desk, *place);
        else if (place)
            desk.session.stroke_to(*place);
    } else if (std::exchange(desk.dab, std::nullopt)) {
        if (desk.done(desk.session.end_painting()))
            desk.tell(desk.tool == Tool::erase ? "erased grass" : "painted grass");
    } else if (desk.done(desk.session.end_stroke())) {
        desk.tell("stroked the grass");
    }
}

/// A ring on the ground under the pointer, as wide as the hand.
void draw_hand(const Desk& desk, const Projection& projection, glm::vec2 pointer) {
    const auto middle = on_ground(desk, projection, pointer);
    if (!middle || ImGui::GetIO().WantCaptureMouse)
        return;
    float radius = desk.brush;
    if (desk.tool == Tool::blow)
        radius *= 3.0f;
    if (paints(desk.tool) && !desk.session.scene().picture.grass.empty())
        radius = std::max(radius, desk.session.finest_brush(static_cast<std::size_t>(desk.layer)));
    constexpr int k_corners = 32;
    std::optional<glm::vec2> before;
    for (int n = 0; n <= k_corners; ++n) {
        const double angle = 2.0 * std::numbers::pi * n / k_corners;
        glm::dvec3 place = *middle + static_cast<double>(radius) * glm::dvec3(std::cos(angle), 0.0, std::sin(angle));
        place.y = desk.ground(place.x, place.z) + 0.05;
        const auto pixel = projection.pixel(place);
        if (pixel && before)
            ImGui::GetBackgroundDrawList()->AddLine({before->x, before->y}, {pixel->x, pixel->y}, k_lit, 1.5f);
        before = pixel;
    }
}

/// A push along the slide, as fast as it is long.
void blow(Desk& desk, glm::dvec3 from, glm::dvec3 to) {
    const glm::dvec3 way = to - from;
    const double length = glm::length(way);
    if (!(length > 0.2))
        return;
    const auto reach = static_cast<float>(std::clamp(0.5 * length, 1.0, 20.0));
    const auto added = desk.session.gust(
        DirectionalMotor{.position = 0.5 * (from + to) + glm::dvec3(0.0, 1.0, 0.0),
                         .direction = glm::vec3(way / length),
                         .region = Sphere{reach},
                         .law = Drive{.speed = std::clamp(2.0f * static_cast<float>(length), 4.0f, 25.0f), .rate = 6.0f},
                         .envelope = {.attack = 0.2f, .hold = 0.6f, .decay = 0.6f}});
    if (desk.done(added ? Result<void>{} : added.failure()))
        desk.tell(message("slid ", desk.session.motors()[*added].name, " of ", std::round(10.0 * length) / 10.0, " m"));
}

} // namespace

namespace {

void draw_slice(Desk& desk, const Projection& projection) {
    // Of a device the moment is that of a frame that came back.
    const double step = static_cast<double>(desk.session.steps());
    if (auto seen = desk.session.look(desk.slice, desk.slice_of, static_cast<double>(desk.overlay.height), step); !seen) {
        desk.slice_of = SliceOf::nothing;
        (void)desk.done(seen);
        return;
    }
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    desk.slice.draw(projection, {size.x - 220.0f, size.y - 50.0f});
}

} // namespace

void draw_overlay(Desk& desk) {
    const Projection projection = projection_of(desk);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const DebugSink sink{
        .line =
            [&](glm::dvec3 from, glm::dvec3 to, std::uint32_t colour) {
                if (const auto line = projection.segment(from, to))
                    list.AddLine({line->first.x, line->first.y}, {line->second.x, line->second.y}, colour, 1.5f);
            },
        .text =
            [&](glm::dvec3 place, std::string_view words, std::uint32_t colour) {
                if (const auto pixel = projection.pixel(place))
                    list.AddText({pixel->x + 6.0f, pixel->y - 6.0f}, colour, words.data(), words.data() + words.size());
            }};
    debug_draw(desk.session.wind(), desk.session.reader(), desk.overlay, sink);
    for (std::size_t place = 0; place < desk.session.levels(); ++place) {
        const Wind& around = desk.session.level(place);
        debug_draw(around, around,
                   {.box = desk.overlay.box, .blend_zone = desk.overlay.blend_zone, .motors = false, .obstacles = false}, sink);
    }
    if (desk.overlay.motors) // those that do not act now
        for (std::size_t n = 0; n < desk.session.motors().size(); ++n)
            if (!desk.session.removed_motor(n) && !desk.session.motors()[n].path && !desk.session.acts(n))
                debug_draw(desk.session.motors()[n].motor, k_dim, sink);
    draw_slice(desk, projection);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto near = nearest(desk, projection, {mouse.x, mouse.y});
    for (const Held& one : held(desk)) {
        const auto pixel = projection.pixel(one.place);
        if (!pixel)
            continue;
        const bool lit = one.choice == desk.chosen || (near && near->choice == one.choice);
        list.AddCircleFilled({pixel->x, pixel->y}, 4.0f, lit ? k_lit : k_plain);
        list.AddCircle({pixel->x, pixel->y}, 8.0f, lit ? k_lit : k_plain);
        if (lit)
            list.AddText({pixel->x + 12.0f, pixel->y - 8.0f}, k_lit, one.name->c_str());
    }
    if (desk.tool != Tool::choose)
        draw_hand(desk, projection, {mouse.x, mouse.y});
    if (desk.gust_from)
        if (const auto to = on_ground(desk, projection, {mouse.x, mouse.y}))
            sink.line(*desk.gust_from, *to, k_lit);
}

void use_pointer(Desk& desk) {
    const ImGuiIO& io = ImGui::GetIO();
    const Projection projection = projection_of(desk);
    const glm::vec2 pointer(io.MousePos.x, io.MousePos.y);
    const float whole = std::max(io.DisplaySize.y, 1.0f);
    if (desk.dragged.kind != Choice::Kind::nothing) {
        if (io.MouseDown[0]) {
            if (io.MouseDelta.x != 0.0f || io.MouseDelta.y != 0.0f)
                drag(desk, projection, pointer);
        } else {
            desk.tell(message("moved ",
                              desk.dragged.kind == Choice::Kind::motor ? desk.session.motors()[desk.dragged.place].name
                                                                       : desk.session.obstacles()[desk.dragged.place].name,
                              " to ", place_of(desk, desk.dragged)));
            desk.dragged = {};
        }
        return;
    }
    if (desk.gust_from && !io.MouseDown[0]) {
        if (const auto to = on_ground(desk, projection, pointer))
            blow(desk, *desk.gust_from, *to);
        desk.gust_from.reset();
    }
    if (desk.session.strokes() || desk.dab)
        move_hand(desk, projection, pointer);
    if (io.WantCaptureMouse)
        return;
    if (ImGui::IsMouseClicked(0)) {
        if (desk.tool != Tool::choose) {
            if (const auto place = on_ground(desk, projection, pointer))
                begin_hand(desk, *place);
        } else if (const auto near = nearest(desk, projection, pointer)) {
            desk.chosen = desk.dragged = near->choice;
            const auto level = projection.on_level(pointer, near->place.y);
            desk.grab = level ? near->place - glm::dvec3(level->x, near->place.y, level->z) : glm::dvec3(0.0);
            return;
        } else {
            desk.chosen = {};
        }
    }
    const double right = static_cast<double>(io.MouseDelta.x / whole), down = static_cast<double>(io.MouseDelta.y / whole);
    if (io.MouseDown[0] && desk.tool == Tool::choose)
        desk.eye.turn(3.0 * right, 3.0 * down);
    if (io.MouseDown[1] || io.MouseDown[2])
        desk.eye.pan(-right, down);
    if (io.MouseWheel != 0.0f)
        desk.eye.zoom(std::pow(0.9, static_cast<double>(io.MouseWheel)));
}

std::string handles_text(const Desk& desk) {
    const Projection projection = projection_of(desk);
    std::string text;
    for (const Held& one : held(desk))
        if (const auto pixel = projection.pixel(one.place))
            text += message("\nhandle ", one.choice.kind == Choice::Kind::motor ? "motor " : "obstacle ", *one.name, ": ",
                            std::round(pixel->x), " ", std::round(pixel->y));
    return text;
}

} // namespace windrow::vegetation::view
