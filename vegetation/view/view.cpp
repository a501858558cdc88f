#include "vegetation/view/view.h"

#include "fluid/core/message.h"
#include "pictures/picture_files.h"
#include "scene/frame_files.h"
#include "vegetation/view/desk.h"
#include "vegetation/view/painter.h"
#include "vegetation/view/window.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <system_error>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

namespace windrow::vegetation::view {
namespace {

using detail::message;
using Clock = std::chrono::steady_clock;

constexpr double k_shortest_frame = 1.0 / 60.0; // [s]
constexpr double k_rest = 0.1;                  // [s] that a window at rest waits for a hand

/// [s] CPU of this thread, or of the process.
double cpu_seconds(clockid_t clock) {
    timespec time{};
    (void)clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// ImGui's context and its window's input.
class Interface {
  public:
    explicit Interface(GLFWwindow* window) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr; // no file is left where it is started
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        ImGui::StyleColorsDark();
        ImGui::GetStyle().FrameBorderSize = 1.0f; // a box that is not ticked is seen on a picture
        ImGui::GetStyle().FrameRounding = 3.0f;
        ImGui::GetStyle().ItemSpacing.y = 3.0f;
        glfwSetWindowUserPointer(window, this);
        glfwSetKeyCallback(window, [](GLFWwindow* of, int key, int, int action, int held) { // ImGui's own calls it
            if (action == GLFW_PRESS)
                static_cast<Interface*>(glfwGetWindowUserPointer(of))
                    ->pressed_.push_back((held & GLFW_MOD_CONTROL) != 0 ? key + k_control : key);
        });
        ImGui_ImplGlfw_InitForVulkan(window, true);
    }
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;
    ~Interface() {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }

    /// Keys since the last call.
    [[nodiscard]] std::vector<int> take_pressed() { return std::exchange(pressed_, {}); }

  private:
    std::vector<int> pressed_{};
};

/// The picture of a draft is half as large as the window, and enlarged.
glm::ivec2 picture_size(VkExtent2D window, bool draft) {
    const glm::ivec2 whole(window.width, window.height);
    return glm::clamp(draft ? whole / 2 : whole, glm::ivec2(16), glm::ivec2(8192));
}

class Loop {
  public:
    Loop(Window& window, Session& session, Interface& interface, Painter& painter, Desk& desk, ViewSummary& summary)
        : window_(window), session_(session), interface_(interface), painter_(painter), desk_(desk), summary_(summary) {}

    Result<void> run() {
        begun_ = last_ = Clock::now();
        cpu_ = cpu_last_ = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
        while (!window_.closed() && !desk_.closes) {
            if (!wait())
                continue;
            look_at_file();
            const auto ready = match();
            if (!ready)
                return ready.failure();
            if (*ready)
                if (auto drawn = frame(); !drawn)
                    return drawn;
        }
        if (desk_.filming)
            desk_.end_film();
        summary_.seconds = since(begun_);
        summary_.cpu_seconds = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu_;
        summary_.panel_ms = summary_.frames > 0 ? 1e3 * panel_cpu_ / summary_.frames : 0.0;
        summary_.resizes = window_.remade() - 1;
        return session_.player().frames().wait();
    }

  private:
    /// For the next frame's time; where nothing moves, for a hand. False: nothing is to be drawn.
    bool wait() {
        // On a software device frames that overlap gain nothing: the hand would wait for two of them.
        if (session_.settings().draft)
            (void)session_.player().frames().wait(); // what fails here fails in the frame
        if (desk_.playing || desk_.filming || session_.chases() || lively_ > 0) {
            const double left = k_shortest_frame - since(last_);
            if (left > 0.0)
                glfwWaitEventsTimeout(left);
            else
                glfwPollEvents();
            lively_ = std::max(lively_ - 1, 0);
            return true;
        }
        const auto begin = Clock::now();
        glfwWaitEventsTimeout(k_rest);
        look_at_file();
        if (since(begin) < k_rest)
            lively_ = 3; // an answer to the hand, and what that leads to
        return lively_ > 0;
    }

    /// Whether there is something to draw on; the picture has the window's size.
    Result<bool> match() {
        const auto sized = window_.match();
        if (!sized || !*sized)
            return sized;
        const VkExtent2D extent = window_.extent();
        if (std::exchange(remade_, window_.remade()) != window_.remade() && summary_.frames > 0)
            desk_.tell(message("the window has ", extent.width, " x ", extent.height, " px"));
        if (auto matched = painter_.match(extent); !matched)
            return matched.failure();
        const glm::ivec2 wanted = picture_size(extent, session_.settings().draft);
        if (wanted != session_.player().size())
            if (auto changed = session_.player().change({.size = wanted}); !changed)
                return changed.failure();
        return true;
    }

    /// A scene that was written by another program is read again.
    void look_at_file() {
        if (since(looked_) < 0.5)
            return;
        looked_ = Clock::now();
        std::error_code error;
        const auto written = std::filesystem::last_write_time(session_.file(), error);
        if (error || written == written_)
            return;
        if (std::exchange(written_, written) == std::filesystem::file_time_type{})
            return; // as it was when it was opened
        desk_.chosen = desk_.dragged = {};
        if (desk_.done(session_.reload()))
            desk_.tell("read the scene again");
        lively_ = 3;
    }

    Result<void> advance(double seconds) {
        if (desk_.filming)
            return session_.play(1.0 / session_.scene().frames_per_second());
        if (desk_.playing || session_.chases())
            return session_.play(desk_.playing ? std::min(seconds, 0.5) * desk_.rate : 0.0);
        return {};
    }

    void note_figures(double seconds) {
        const Diagnostics last = session_.reader().diagnostics();
        desk_.figures.speed.add(static_cast<double>(last.max_speed));
        desk_.figures.cfl.add(static_cast<double>(last.cfl));
        desk_.figures.energy.add(last.energy);
        desk_.figures.step_ms.add(last.times_ms.total);
        desk_.figures.frame_ms.add(1e3 * seconds);
        const double now = cpu_seconds(CLOCK_PROCESS_CPUTIME_ID);
        desk_.figures.cpu_ms.add(1e3 * (now - std::exchange(cpu_last_, now)));
        double device_us = 0.0;
        for (const render::StageTime& stage : session_.player().times())
            device_us += stage.us;
        desk_.figures.device_ms.add(1e-3 * device_us);
    }

    Result<void> frame() {
        const double seconds = since(last_);
        last_ = Clock::now();
        const double before_panel = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        desk_.keys = interface_.take_pressed();
        use_keys(desk_, std::min(seconds, 0.2));
        use_pointer(desk_);
        double panel = cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - before_panel;
        if (const auto advanced = advance(seconds); !advanced) {
            (void)desk_.done(advanced);
            desk_.playing = false;
        }
        desk_.eye.follow(session_.scene().air.followed_point(session_.time()));
        const bool filming = desk_.filming.has_value(), kept = filming || std::exchange(desk_.wants_picture, false);
        note_figures(seconds);

        const double panel_begin = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        ImGui::GetBackgroundDrawList()->AddImage(k_picture, {0.0f, 0.0f}, ImGui::GetIO().DisplaySize);
        draw_overlay(desk_);
        if (desk_.panel)
            draw_panels(desk_);
        ImGui::Render();
        panel += cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - panel_begin;

        auto& frames = session_.player().frames();
        const auto begun = frames.begin();
        if (!begun)
            return begun.failure();
        const auto target = window_.acquire(begun->slot);
        if (!target)
            return target.failure();
        if (auto recorded = session_.record(*begun, desk_.camera(), kept); !recorded)
            return recorded;
        const double present = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
        if (auto painted = painter_.record(*begun, *ImGui::GetDrawData(), session_.player().images().toned_image()); !painted)
            return painted;
        if (*target)
            window_.copy(begun->commands, **target, painter_.screen());
        panel += cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - present;
        if (auto submitted = frames.submit(*begun, *target ? (**target).signals : engine::Signals{}); !submitted)
            return submitted;
        if (*target) {
            const double shown = cpu_seconds(CLOCK_THREAD_CPUTIME_ID);
            if (auto done = window_.show(**target); !done)
                return done;
            panel += cpu_seconds(CLOCK_THREAD_CPUTIME_ID) - shown;
        }
        panel_cpu_ += panel;
        if (summary_.frames++ == 0)
            desk_.tell("opened " + session_.file().string());
        return kept ? keep(filming) : Result<void>{};
    }

    /// The picture of the frame just submitted.
    Result<void> keep(bool filming) {
        if (auto done = session_.player().frames().wait(); !done)
            return done;
        const render::Picture8 picture = session_.player().images().picture();
        const std::filesystem::path file =
            filming ? desk_.filming->folder / scene::FrameFiles{"frame_", ".png"}.name(desk_.filming->frames++)
                    : std::filesystem::path(desk_.picture_file);
        if (desk_.done(pictures::write_png(picture, file)) && !filming)
            desk_.tell("wrote the picture " + file.string());
        return {};
    }

    Window& window_;
    Session& session_;
    Interface& interface_;
    Painter& painter_;
    Desk& desk_;
    ViewSummary& summary_;
    Clock::time_point begun_{}, last_{}, looked_{};
    std::filesystem::file_time_type written_{};
    double cpu_ = 0.0, cpu_last_ = 0.0, panel_cpu_ = 0.0; // [s]
    int lively_ = 3, remade_ = 0;
};

} // namespace

Result<ViewSummary> view(const ViewRequest& request, const std::function<void(const std::string& line)>& say) {
    ViewSummary summary;
    auto window = Window::create({.size = request.size,
                                  .title = request.scene.stem().string() + " - windrow",
                                  .validation = request.validation,
                                  .on_message = [&](const std::string& text) {
                                      ++summary.messages;
                                      say("validation: " + text);
                                  }});
    if (!window)
        return window.failure();
    engine::Device& device = (*window)->device();
    const bool draft = request.look == Look::draft || (request.look == Look::automatic && device.software());
    {
        if (const auto sized = (*window)->match(); !sized)
            return sized.failure();
        auto session =
            Session::open(device, request.scene,
                          {.draft = draft, .backend = request.backend, .size = picture_size((*window)->extent(), draft)});
        if (!session)
            return session.failure();
        Interface interface((*window)->handle());
        auto painter = Painter::create(device, (*window)->format());
        if (!painter)
            return painter.failure();
        Desk desk(**session);
        desk.say = say;
        desk.playing = !request.paused;
        desk.panel = request.panel;
        desk.write_vdb = request.write_vdb;
        desk.device = summary.device = device.name() + (draft ? ", draft look" : ", full look");
        if (auto done = Loop(**window, **session, interface, **painter, desk, summary).run(); !done)
            return done.failure();
    }
    window->reset();
    return summary;
}

} // namespace windrow::vegetation::view
