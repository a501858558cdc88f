// Flags of a command, which CLI11 reads straight into what the command is asked for. What is wrong with a value is said in a
// sentence of ours: CLI11's own do not say what would be right.
#pragma once

#include "cli/backend.h"
#include "cli/console.h"
#include "fluid/core/message.h"
#include "fluid/simd.h"
#include "scene/part.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace windrow::cli {

/// Ends reading: the sentence is whole.
struct WrongFlag : CLI::ParseError {
    explicit WrongFlag(const std::string& sentence) : ParseError("WrongFlag", sentence, CLI::ExitCodes::ValidationError) {}
};
template <class... Parts>
[[noreturn]] void reject(const Parts&... parts) {
    throw WrongFlag(detail::message(parts...));
}

/// Most threads that a command takes; more than cores only makes them wait for each other.
inline constexpr int k_max_threads = 256;
/// [s] The longest that a measurement is asked to take.
inline constexpr double k_max_seconds = 3600.0;

/// Adds flags to a command and reads their values into places that outlive the parsing.
class Flags {
  public:
    explicit Flags(CLI::App& command) : command_(command) {}

    using Read = std::function<void(const std::string& text)>;
    /// A value that `read` takes, or rejects. A flag in its place is rejected here: "--out --vdb" would name a folder.
    CLI::Option* value(const std::string& name, const char* type, const std::string& help, Read read);
    /// The same for a flag that takes several values, given once or often.
    void values(const std::string& name, const char* type, const std::string& help, Read read);

    void threads(int& threads, const std::string& help = "Threads; default one a core");
    void simd(Simd& simd, const std::string& help);
    void seconds(double& seconds, const std::string& help);
    /// SCENE.json, which is required.
    void scene(std::filesystem::path& file);
    void file(const std::string& name, std::optional<std::filesystem::path>& file, const std::string& help);
    void folder(const std::string& name, std::optional<std::filesystem::path>& folder, const std::string& help);
    /// --backend and --device; what goes with what is checked by check_backend.
    void backend(BackendRequest& backend);
    /// --part K/N of `what`.
    void part(scene::Part& part, const std::string& what);
    /// --device alone, for commands that run on Vulkan whatever is asked.
    void device(int& device);

  private:
    CLI::App& command_;
};

/// What runs a command on its request; Ctrl-C asks it to stop.
template <class Request>
[[nodiscard]] std::function<int()> interruptible(int (*run)(const Request&, const Console&, const std::function<int()>&),
                                                 std::shared_ptr<const Request> request, const Console& console) {
    return [run, request = std::move(request), &console] {
        const InterruptGuard guard;
        return run(*request, console, &InterruptGuard::signal);
    };
}

/// A value as a sentence shows it.
[[nodiscard]] inline std::string_view shown(const std::string& text) {
    return text.empty() ? std::string_view("empty") : std::string_view(text);
}
/// A whole number from 1 to `most`.
[[nodiscard]] std::int64_t read_count(const std::string& text, const std::string& flag, std::int64_t most);
/// Rejects a backend that is not built in, and a device without Vulkan.
void check_backend(const CLI::App& command, const BackendRequest& backend);

} // namespace windrow::cli
