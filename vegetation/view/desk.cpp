#include "vegetation/view/desk.h"

#include "fluid/core/message.h"
#include "fluid/field_files.h"
#include "fluid/files/new_file.h"
#include "scene/config_text.h"
#include "vegetation/program/film.h"

#include <algorithm>
#include <cmath>
#include <system_error>

namespace windrow::vegetation::view {
namespace {

using detail::message;

} // namespace

Desk::Desk(Session& its_session) : session(its_session), eye(program::camera_at(its_session.scene(), 0.0)) {
    const std::filesystem::path& file = session.file();
    const auto beside = [&](const std::string& name) { return (file.parent_path() / name).string(); };
    const std::string stem = file.stem().string();
    scene_file = beside(stem + "_edited.json");
    picture_file = stem + ".png";
    fields_file = stem + ".raw";
    vdb_file = stem + ".vdb";
    cpp_file = stem + "_config.h";
    log_folder = stem + "_log";
    film_file = stem + ".webp";
    overlay.speed = session.scene().air.pictures.speed_scale;
}

const ToolName& name_of(Tool tool) {
    static constexpr std::array<ToolName, k_tools> k_names{
        {{"choose", "chooses", "Circles, and drags what has a handle."},
         {"gust", "slides gusts", "Pull over the ground: a push of air along that way, as fast as it is long."},
         {"press", "presses grass", "Stroke the grass: it is trodden, and the air follows the hand at its own speed."},
         {"comb", "combs grass", "Stroke the grass: blades lie along the stroke, and the air follows the hand."},
         {"blow", "blows", "Click on the ground: a blast there, three times as wide as the hand."},
         {"paint", "paints grass", "Stroke the ground: grass of the layer comes."},
         {"erase", "erases grass", "Stroke the ground: grass of all layers goes."}}};
    return k_names[static_cast<std::size_t>(tool)];
}

bool Desk::done(const Result<void>& result) {
    fault = result ? std::string() : result.error();
    return static_cast<bool>(result);
}

void Desk::tell(const std::string& what) {
    if (say)
        say(message(std::round(session.time() * 1e4) / 1e4, " s: ", what));
}

render::Camera Desk::camera() const {
    return eye.camera(program::camera_at(session.scene(), session.time()));
}

double Desk::ground(double x, double z) const {
    return session.scene().picture.ground.height(x, z);
}

void Desk::add_house(glm::dvec3 foot) {
    const glm::vec3 box = session.wind().box().size();
    const glm::vec3 half = std::clamp(0.04f * std::min(box.x, box.z), 0.1f, 1.0f) * glm::vec3(2.5f, 2.0f, 2.0f);
    const auto added =
        session.add_obstacle({.position = foot + glm::dvec3(0.0, static_cast<double>(half.y), 0.0), .shape = Block{half}},
                             message("house ", session.obstacles().size() + 1));
    if (!done(added ? Result<void>{} : added.failure()))
        return;
    chosen = {Choice::Kind::obstacle, *added};
    tell(message("added ", session.obstacles()[*added].name, " at ", foot));
}

void Desk::add_fan(glm::dvec3 foot) {
    const auto added =
        session.add_motor(JetMotor{.position = foot + glm::dvec3(0.0, 1.5, 0.0), .direction = {1.0f, 0.0f, 0.0f}, .length = 8.0f},
                          message("fan ", session.motors().size() + 1));
    if (!done(added ? Result<void>{} : added.failure()))
        return;
    chosen = {Choice::Kind::motor, *added};
    tell(message("added ", session.motors()[*added].name, " at ", foot));
}

void Desk::remove_chosen() {
    const Choice gone = std::exchange(chosen, {});
    if (gone.kind == Choice::Kind::motor && done(session.remove_motor(gone.place)))
        tell("removed " + session.motors()[gone.place].name);
    if (gone.kind == Choice::Kind::obstacle && done(session.remove_obstacle(gone.place)))
        tell("removed " + session.obstacles()[gone.place].name);
}

void Desk::save_field() {
    const auto air = session.reader().view();
    if (!done(air ? Result<void>{} : air.failure()))
        return;
    FieldGrid grid = field_grid(*air);
    grid.time = session.time();
    if (done(write_field(fields_file, FieldFormat::raw, grid)))
        tell("wrote " + fields_file);
}

void Desk::save_vdb() {
    if (!write_vdb)
        fault = "this build writes no VDB: install libopenvdb-dev and build again.";
    else if (done(write_vdb(vdb_file, session.wind(), session.reader())))
        tell("wrote " + vdb_file);
}

void Desk::save_cpp() {
    const auto text = scene::write_cpp(session.air());
    if (!done(text ? Result<void>{} : text.failure()))
        return;
    const std::string whole = message("// Settings of the wind of ", session.file().filename().string(),
                                      ", as windrow view had them.\n#pragma once\n\n#include <windrow/fluid/config.h>\n\n"
                                      "inline const windrow::Config k_wind = ",
                                      *text, ";\n");
    if (done(detail::write_file("settings", cpp_file, whole)))
        tell("wrote " + cpp_file);
}

void Desk::save_log() {
    std::error_code error;
    std::filesystem::create_directories(log_folder, error);
    if (done(session.save_log(log_folder)))
        tell("wrote the log " + log_folder);
}

void Desk::take(Tool chosen_tool) {
    tool = chosen_tool;
    tell(name_of(tool).said);
}

void Desk::cut(SliceOf what) {
    slice_of = what;
    constexpr std::array<const char*, k_slices> k_names{"nothing", "pressure", "divergence"};
    tell(message("cuts ", k_names[static_cast<std::size_t>(what)]));
}

void Desk::set_solver(program::Backend backend) {
    if (done(session.set_solver(backend)))
        tell(message("the air is solved on the ", backend == program::Backend::cpu ? "CPU" : "device"));
}

void Desk::compare() {
    constexpr int k_ticks = 10;
    const auto found = session.compare_solvers(k_ticks);
    if (!done(found ? Result<void>{} : found.failure()))
        return;
    difference = *found;
    tell(message("the solvers differ by ", found->largest, " m/s after ", found->ticks, " ticks"));
}

void Desk::begin_film() {
    const std::filesystem::path file = film_file;
    if (const program::FilmFault wrong = program::fault_of_film(file); !wrong.sentence.empty()) {
        fault = wrong.sentence;
        return;
    }
    std::filesystem::path folder = file;
    folder += "_frames";
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        fault = message(folder.string(), " cannot be made (", error.message(), "): give another name.");
        return;
    }
    filming = Filming{.folder = folder};
    tell("began the film " + film_file);
}

void Desk::end_film() {
    const Filming kept = *std::exchange(filming, std::nullopt);
    if (kept.frames == 0)
        return;
    program::Film film{.file = film_file};
    film.size = session.player().size();
    film.frames_per_second = session.scene().frames_per_second();
    film.shots.push_back({.folder = kept.folder, .first = 0, .count = kept.frames});
    if (done(program::write_film(film, {"frame_", ".png"})))
        tell(message("wrote the film ", film_file, " of ", kept.frames, " frames"));
}

} // namespace windrow::vegetation::view
