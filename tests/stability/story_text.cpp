#include "tests/stability/story.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>
#include <string_view>

namespace windrow::test {
namespace {

// Digits enough that a compiler reads the same bits.
std::string literal(double value, int digits, const char* suffix, const char* type) {
    if (std::isnan(value))
        return std::string("std::numeric_limits<") + type + ">::quiet_NaN()";
    if (std::isinf(value))
        return std::string(value < 0.0 ? "-" : "") + "std::numeric_limits<" + type + ">::infinity()";
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    std::string number = text;
    if (number.find_first_of(".e") == std::string::npos)
        number += ".0";
    return number + suffix;
}

/// {.first = 1.0f, .second = {...}}
class Fields {
  public:
    explicit Fields(std::string_view type) : text_(std::string(type) + '{') {}

    template <class Value>
    Fields& operator()(const char* name, const Value& value) {
        text_ += (empty_ ? "." : ", .") + std::string(name) + " = " + text(value);
        empty_ = false;
        return *this;
    }
    /// Left out where it is the default.
    template <class Value>
    Fields& operator()(const char* name, const Value& value, const Value& standard) {
        return value == standard ? *this : (*this)(name, value);
    }
    [[nodiscard]] std::string done() const { return text_ + '}'; }

    static std::string text(float value) { return literal(static_cast<double>(value), 9, "f", "float"); }
    static std::string text(double value) { return literal(value, 17, "", "double"); }
    static std::string text(int value) { return std::to_string(value); }
    static std::string text(std::uint32_t value) { return std::to_string(value) + 'u'; }
    static std::string text(bool value) { return value ? "true" : "false"; }
    template <class Number>
    static std::string text(const glm::vec<3, Number>& v) {
        return '{' + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + '}';
    }
    static std::string text(SideKind kind) {
        constexpr const char* k_names[] = {"open", "free_slip", "no_slip", "periodic"};
        return std::string("SideKind::") + k_names[static_cast<int>(kind)];
    }
    static std::string text(const Side& side) {
        return Fields("")("kind", side.kind, SideKind::open)("wall_velocity", side.wall_velocity, glm::vec3(0.0f)).done();
    }
    static std::string text(const Sides& sides) {
        const Side open;
        return Fields("")("x_low", sides.x_low, open)("x_high", sides.x_high, open)("y_low", sides.y_low, open)(
                   "y_high", sides.y_high, open)("z_low", sides.z_low, open)("z_high", sides.z_high, open)
            .done();
    }
    static std::string text(const LogProfile& profile) {
        return Fields("LogProfile")("roughness_length", profile.roughness_length)("reference_height", profile.reference_height)
            .done();
    }
    static std::string text(const Gusts& gusts) {
        return Fields("Gusts")("intensity", gusts.intensity)("length", gusts.length)("seed", gusts.seed).done();
    }
    static std::string text(Scheme scheme) {
        return scheme == Scheme::second_order ? "Scheme::second_order" : "Scheme::stable_fluids";
    }
    static std::string text(Interpolation interpolation) {
        return interpolation == Interpolation::cubic ? "Interpolation::cubic" : "Interpolation::linear";
    }
    static std::string text(const Stages& stages) {
        return Fields("")("sources", stages.sources, true)("settling", stages.settling, true)(
                   "diffusion", stages.diffusion, true)("advection", stages.advection, true)("projection", stages.projection,
                                                                                             true)
            .done();
    }
    static std::string text(const Ticks& ticks) { return Fields("")("hz", ticks.hz)("most", ticks.most).done(); }
    static std::string text(const Config& config) {
        const Config standard;
        Fields fields("");
        fields("cells", config.cells)("cell_size", config.cell_size, standard.cell_size)("sides", config.sides, standard.sides)(
            "centre", config.centre, standard.centre)("ambient", config.ambient, standard.ambient);
        if (config.profile)
            fields("profile", *config.profile);
        if (config.gusts.intensity != 0.0f)
            fields("gusts", config.gusts);
        fields("rim", config.rim, standard.rim)("viscosity", config.viscosity, standard.viscosity)(
            "settling_time", config.settling_time, standard.settling_time)("sleep_speed", config.sleep_speed,
                                                                           standard.sleep_speed)(
            "scheme", config.scheme, standard.scheme)("interpolation", config.interpolation, standard.interpolation)(
            "max_cfl", config.max_cfl, standard.max_cfl)("max_substeps", config.max_substeps, standard.max_substeps);
        if (const std::string stages = text(config.stages); stages != "{}")
            fields("stages", config.stages);
        if (config.ticks.hz != standard.ticks.hz || config.ticks.most != standard.ticks.most)
            fields("ticks", config.ticks);
        return fields.done();
    }
    static std::string text(const story::Start& start) {
        constexpr const char* k_names[] = {"ambient", "white", "smooth", "shear"};
        return std::string("{story::Start::Kind::") + k_names[static_cast<int>(start.kind)] + ", " + text(start.speed) + ", " +
               text(start.seed) + ", " + text(start.projected) + '}';
    }

    // --- Motors -------------------------------------------------------------------------------------------------------
    static std::string text(const Turbulence& turbulence) {
        return Fields("")("intensity", turbulence.intensity)("length", turbulence.length)("seed", turbulence.seed).done();
    }
    static std::string text(const Envelope& envelope) {
        return Fields("")("attack", envelope.attack)("hold", envelope.hold)("decay", envelope.decay).done();
    }
    static std::string text(const Region& region) {
        if (const auto* ball = std::get_if<Sphere>(&region))
            return "Sphere{" + text(ball->radius) + '}';
        if (const auto* capsule = std::get_if<Capsule>(&region))
            return "Capsule{" + text(capsule->half_axis) + ", " + text(capsule->radius) + '}';
        if (const auto* box = std::get_if<AlignedBox>(&region))
            return "AlignedBox{" + text(box->half_size) + '}';
        const auto& cone = std::get<Cone>(region);
        return "Cone{" + text(cone.axis) + ", " + text(cone.start_radius) + ", " + text(cone.end_radius) + '}';
    }
    static std::string text(const std::variant<Force, Drive>& law) {
        if (const auto* force = std::get_if<Force>(&law))
            return "Force{" + text(force->acceleration) + '}';
        return "Drive{" + text(std::get<Drive>(law).speed) + ", " + text(std::get<Drive>(law).rate) + '}';
    }
    static std::string text(const std::variant<WakeForce, WakeDrive>& law) {
        if (const auto* force = std::get_if<WakeForce>(&law))
            return "WakeForce{" + text(force->strength) + '}';
        return "WakeDrive{" + text(std::get<WakeDrive>(law).per_metre) + ", " + text(std::get<WakeDrive>(law).entrainment) + '}';
    }
    static std::string text(const Motor& motor) {
        if (const auto* fan = std::get_if<DirectionalMotor>(&motor))
            return Fields("DirectionalMotor")("position", fan->position)("direction", fan->direction)("region", fan->region)(
                       "law", fan->law)("envelope", fan->envelope)("turbulence", fan->turbulence)
                .done();
        if (const auto* wake = std::get_if<WakeMotor>(&motor))
            return Fields("WakeMotor")("position", wake->position)("radius", wake->radius)("law", wake->law)(
                       "envelope", wake->envelope)("turbulence", wake->turbulence)
                .done();
        if (const auto* jet = std::get_if<JetMotor>(&motor))
            return Fields("JetMotor")("position", jet->position)("direction", jet->direction)("length", jet->length)(
                       "start_radius", jet->start_radius)("end_radius", jet->end_radius)("law", jet->law)(
                       "envelope", jet->envelope)("turbulence", jet->turbulence)
                .done();
        if (const auto* vortex = std::get_if<VortexMotor>(&motor))
            return Fields("VortexMotor")("position", vortex->position)("axis", vortex->axis)("radius", vortex->radius)(
                       "half_length", vortex->half_length)("lift", vortex->lift)("law", vortex->law)("envelope", vortex->envelope)
                .done();
        if (const auto* omni = std::get_if<OmniMotor>(&motor))
            return Fields("OmniMotor")("position", omni->position)("radius", omni->radius)("speed", omni->speed)("envelope",
                                                                                                                 omni->envelope)
                .done();
        const auto& burst = std::get<PressureMotor>(motor);
        return Fields("PressureMotor")("position", burst.position)("radius", burst.radius)("speed", burst.speed)("duration",
                                                                                                                 burst.duration)
            .done();
    }

  private:
    std::string text_;
    bool empty_ = true;
};

struct EventText {
    using Text = Fields;
    std::string operator()(const story::Steps& e) const { return "Steps{" + Text::text(e.count) + ", " + Text::text(e.dt) + '}'; }
    std::string operator()(const story::Frames& e) const {
        return "Frames{" + Text::text(e.count) + ", " + Text::text(e.dt) + '}';
    }
    std::string operator()(const story::Add& e) const { return "Add{" + Text::text(e.motor) + '}'; }
    std::string operator()(const story::Replace& e) const {
        return "Replace{" + Text::text(e.which) + ", " + Text::text(e.motor) + '}';
    }
    std::string operator()(const story::Move& e) const {
        return "Move{" + Text::text(e.which) + ", " + Text::text(e.position) + '}';
    }
    std::string operator()(const story::Remove& e) const { return "Remove{" + Text::text(e.which) + '}'; }
    std::string operator()(const story::Follow& e) const { return "Follow{" + Text::text(e.point) + '}'; }
    std::string operator()(const story::Floor& e) const { return "Floor{" + Text::text(e.height) + '}'; }
    std::string operator()(const story::ChangeSides& e) const { return "ChangeSides{Sides" + Text::text(e.sides) + '}'; }
    std::string operator()(const story::ChangeAmbient& e) const { return "ChangeAmbient{" + Text::text(e.ambient) + '}'; }
    std::string operator()(const story::ChangeGusts& e) const { return "ChangeGusts{" + Text::text(e.gusts) + '}'; }
    std::string operator()(const story::Break& e) const {
        return "Break{" + Text::text(e.cell) + ", " + Text::text(e.value) + '}';
    }
    std::string operator()(const story::SaveAndLoad&) const { return "SaveAndLoad{}"; }
    std::string operator()(const story::Reset&) const { return "Reset{}"; }
};

} // namespace

std::string text_of(const Story& story) {
    std::string text = "story_of(" + Fields::text(story.config) + ",\n         " + Fields::text(story.start) + ",\n         {";
    for (std::size_t n = 0; n < story.events.size(); ++n)
        text += (n > 0 ? ",\n          story::" : "story::") + std::visit(EventText{}, story.events[n]);
    return text + "})";
}

void showValue(const Story& story, std::ostream& stream) {
    stream << '\n' << text_of(story);
}

} // namespace windrow::test
