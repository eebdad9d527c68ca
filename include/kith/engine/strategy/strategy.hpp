// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/base/in_library.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace kith {

/// The ways to make the levels of a refinement. All of them make the same bits.
enum class refinement_way : unsigned char {
    by_levels,        ///< each level from the one before
    in_surface_order, ///< each level from the one before, where faces were put in the order of the surface first
    in_patches        ///< the last steps at once, by templates for faces that look alike
};

/// The reasons for a way. All but the first two concern patches.
enum class strategy_reason : unsigned char {
    forced,          ///< `force_way` asks for it
    gain,            ///< this way takes less time than level by level
    no_patches,      ///< there is no step, or the scheme, the type of points or the mesh has no patches
    few_faces,       ///< the last level has too few faces
    looked_in_vain,  ///< patches were no gain for such a level before
    small_patches,   ///< finding the classes of faces costs more than such small patches save
    unlike_faces,    ///< too few faces look alike, also after some steps
    scattered_faces, ///< faces lie in no order, and small patches gain nothing there
    all_levels,      ///< the levels between are wanted, too
    single_steps,    ///< carried values follow single steps
    state,           ///< the state of the scheme says which elements are made
    many_classes     ///< too few faces share a template
};

/// The way in which a refinement makes its levels, and the reason, as returned by `strategy_of`.
struct strategy {
    refinement_way way = refinement_way::by_levels;
    strategy_reason reason = strategy_reason::no_patches;
    bool is_ordered = false;   ///< the faces were put in the order of the surface first
    int begin = 0;             ///< the level whose faces own patches, if there are patches
    double faces = 0;          ///< the faces of the last level
    double needed = 0;         ///< how many faces of a last level, or of a patch, would be enough
    std::size_t classes = 0;   ///< classes of faces that look alike, if they were looked for
    std::size_t templates = 0; ///< of how many of these classes there is a template
};

/// Returns a strategy as a sentence for a reader, such as "in patches from level 3 on: 12 classes of faces, 12 with
/// templates".
std::string explain(const strategy& how);

#ifdef KITH_HAS_BODIES
KITH_IN_LIBRARY std::string explain(const strategy& how)
{
    const auto number = [](double n) { return std::to_string(std::uint64_t(n)); };
    const std::string classes = std::to_string(how.classes) + (how.classes == 1 ? " class" : " classes") + " of faces";
    const auto because = [&]() -> std::string {
        switch (how.reason) {
        case strategy_reason::forced: return "as asked for";
        case strategy_reason::gain:
            return how.way == refinement_way::in_patches
                       ? classes + ", " + std::to_string(how.templates) + " with templates"
                       : "the faces of the control mesh lie in no order";
        case strategy_reason::no_patches: return "the scheme, its points or the mesh have no patches";
        case strategy_reason::few_faces:
            return number(how.faces) + " faces are fewer than " + number(how.needed) + ", where templates begin to pay";
        case strategy_reason::looked_in_vain:
            return "patches were no gain before; they are tried again after " + number(how.needed) + " faces";
        case strategy_reason::small_patches: return "patches are too small to pay for finding faces that look alike";
        case strategy_reason::unlike_faces: return "too few faces look alike";
        case strategy_reason::scattered_faces:
            return "faces lie in no order, and patches of fewer than " + number(how.needed) +
                   " faces gain nothing there";
        case strategy_reason::all_levels: return "the levels between are wanted, too";
        case strategy_reason::single_steps: return "values that are carried along follow single steps";
        case strategy_reason::state: return "the state of the scheme says which elements are made";
        case strategy_reason::many_classes: return classes + " are too many for templates to pay";
        }
        return {};
    };
    std::string result;
    switch (how.way) {
    case refinement_way::by_levels: result = "level by level: "; break;
    case refinement_way::in_surface_order: result = "level by level in the order of the surface: "; break;
    case refinement_way::in_patches:
        result = "in patches from level " + std::to_string(how.begin) + " on" +
                 (how.is_ordered ? ", in the order of the surface: " : ": ");
        break;
    }
    return result + because();
}
#endif

namespace detail {

inline constexpr unsigned char no_way = 255;
constinit inline std::atomic<unsigned char> way_that_is_forced = no_way;

} // namespace detail

/// Makes all refinements of the process go this way where they can, until it is called with nothing. It is meant for
/// tests, comparisons and fault reports: results do not depend on the way. Call it while nothing is being refined.
inline void force_way(std::optional<refinement_way> way)
{
    detail::way_that_is_forced = way ? static_cast<unsigned char>(*way) : detail::no_way;
}
/// Returns the way that is forced, if there is one.
inline std::optional<refinement_way> forced_way()
{
    const unsigned char way = detail::way_that_is_forced.load(std::memory_order_relaxed);
    return way == detail::no_way ? std::nullopt : std::optional(static_cast<refinement_way>(way));
}

} // namespace kith
