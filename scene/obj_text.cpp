#include "scene/obj_text.h"

#include "fluid/core/message.h"
#include "fluid/files/text_lines.h"

#include <array>
#include <charconv>
#include <cmath>

namespace windrow::scene {
namespace {

using detail::message, detail::take_word, detail::trimmed;

constexpr std::size_t k_max_libraries = 64;

class Scanner {
  public:
    Scanner(std::string_view text, const std::string& name, const ObjLimits& limits)
        : lines_(text), name_(name), limits_(limits) {
        out_.text.reserve(text.size());
    }

    Result<ObjText> run() {
        for (std::string_view line; fault_.empty() && lines_.next(line);)
            statement(line);
        if (fault_.empty() && triangles_ == 0)
            return Error{message(name_, " has no faces: give a mesh of triangles.")};
        if (!fault_.empty())
            return Error{fault_};
        return std::move(out_);
    }

  private:
    // Index kinds of a corner, in the order in which they are written.
    enum Kind { position, uv, normal };

    template <class... Words>
    void fail(const Words&... words) {
        fault_ = message(name_, ":", lines_.number(), ": ", words...);
    }

    void statement(std::string_view line) {
        if (line.find('\0') != std::string_view::npos)
            return fail("the line has a zero byte: give text.");
        const std::string_view key = take_word(line);
        if (!key.empty() && key.front() != '#' && !line.empty() && line.back() == '\\')
            return fail("the line ends in a backslash: join it with the next.");
        if (key == "v")
            numbers(position, "v ", line, 3, 3);
        else if (key == "vt")
            numbers(uv, "vt ", line, 1, 2);
        else if (key == "vn")
            numbers(normal, "vn ", line, 3, 3);
        else if (key == "f")
            face(line);
        else if (key == "usemtl")
            keep("usemtl ", trimmed(line));
        else if (key == "mtllib")
            library(trimmed(line));
    }

    // A material's name as it stands.
    void keep(std::string_view key, std::string_view words) {
        if (words.size() > 255)
            return fail("the material's name has ", words.size(), " bytes: give at most 255.");
        if (words.empty())
            words = "none";
        detail::append(out_.text, key);
        detail::append(out_.text, words);
        out_.text += '\n';
    }

    void library(std::string_view words) {
        if (out_.libraries.size() == k_max_libraries)
            return fail("there are more than ", k_max_libraries, " mtllib lines: give fewer.");
        out_.libraries.emplace_back(words);
    }

    // The first of these are needed, those up to `most` kept, and the rest (w, colours) left out.
    void numbers(Kind kind, std::string_view key, std::string_view words, int least, int most) {
        if (++counts_[kind] > limits_.vertices)
            return fail("there are more than ", limits_.vertices, " lines ", key, ": give fewer.");
        detail::append(out_.text, key);
        for (int i = 0; i < most; ++i) {
            std::string_view word = take_word(words);
            const std::string_view written = word;
            if (word.empty() && i >= least)
                word = "0";
            if (word.starts_with('+'))
                word.remove_prefix(1);
            float value = 0.0f;
            const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
            if (fault != std::errc() || end != word.data() + word.size() || !(std::abs(value) <= 1e30f))
                return fail(key, "has '", written, "': give ", least, " finite numbers.");
            detail::append(out_.text, value);
            out_.text += i + 1 < most ? ' ' : '\n';
        }
    }

    // One index of a corner, from 1; 0: rejected.
    std::size_t index(Kind kind, std::string_view word) {
        long long value = 0;
        const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
        const auto count = static_cast<long long>(counts_[kind]);
        if (fault != std::errc() || end != word.data() + word.size() || value == 0 || value > count || value < -count) {
            constexpr std::array<std::string_view, 3> names{"v", "vt", "vn"};
            fail("the face's index '", word, "' means no ", names[kind], " above it: give 1 to ", count, ".");
            return 0;
        }
        return static_cast<std::size_t>(value < 0 ? count + value + 1 : value);
    }

    void face(std::string_view words) {
        std::size_t corners = 0;
        std::array<bool, 3> first{};
        out_.text += 'f';
        for (std::string_view word = take_word(words); !word.empty(); word = take_word(words), ++corners) {
            std::array<std::string_view, 3> parts;
            std::size_t part = 0;
            for (; part < 3; ++part) {
                const std::size_t slash = word.find('/');
                parts[part] = word.substr(0, slash);
                if (slash == std::string_view::npos)
                    break;
                word.remove_prefix(slash + 1);
            }
            const std::array<bool, 3> has{true, !parts[uv].empty(), !parts[normal].empty()};
            if (corners == 0)
                first = has;
            if (part == 3 || has != first)
                return fail("the face's corners are of different kinds: give all as v, v/vt, v//vn or v/vt/vn.");
            for (const Kind kind : {position, uv, normal}) {
                if (!has[kind])
                    continue;
                const std::size_t number = index(kind, parts[kind]);
                if (number == 0)
                    return;
                out_.text += kind == position ? " " : kind == normal && !has[uv] ? "//" : "/";
                detail::append(out_.text, number);
            }
        }
        if (corners < 3 || corners > k_max_corners)
            return fail("the face has ", corners, " corners: give 3 to ", k_max_corners, ".");
        triangles_ += corners - 2;
        if (triangles_ > limits_.triangles)
            return fail("there are more than ", limits_.triangles, " triangles: give fewer.");
        out_.text += '\n';
    }

    detail::TextLines lines_;
    const std::string& name_;
    const ObjLimits& limits_;
    ObjText out_;
    std::array<std::size_t, 3> counts_{};
    std::size_t triangles_ = 0;
    std::string fault_;
};

} // namespace

Result<ObjText> check_obj(std::string_view text, const std::string& name, const ObjLimits& limits) {
    return Scanner(text, name, limits).run();
}

} // namespace windrow::scene
