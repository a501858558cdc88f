#include "vegetation/view/desk.h"

#include "fluid/core/message.h"
#include "fluid/field_files.h"
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
    log_folder = stem + "_log";
    film_file = stem + ".webp";
    overlay.speed = session.scene().air.pictures.speed_scale;
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
