// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "attribute_fields.hpp"
#include "mesh_input.hpp"

#include <kith/compiled_schemes.hpp>

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace kith::tool {

/// A scheme that the program knows, and where it comes from. Its name, what it takes and its options its type says.
template <class Scheme>
struct scheme_entry {
    std::string_view source;
    basic_mesh<> (*prepare)(const basic_mesh<>&,
                            attribute_fields&) = nullptr; ///< makes of any mesh one that the scheme can start from
};

namespace detail {

template <class Scheme>
constexpr scheme_entry<Scheme> entry_of()
{
    if constexpr (std::same_as<Scheme, four_eight>)
        return {paper_of<Scheme>, [](const basic_mesh<>& mesh, attribute_fields& attributes) {
                    return tri_quad(mesh, std::tie(attributes));
                }};
    else
        return {paper_of<Scheme>};
}
template <class... Schemes>
constexpr std::tuple<scheme_entry<Schemes>...> entries_of(const std::tuple<Schemes...>*)
{
    return {entry_of<Schemes>()...};
}
template <class... Schemes>
std::variant<Schemes...> variant_of(const std::tuple<Schemes...>*);

} // namespace detail

/// All verbs take their schemes from here: those of the registry.
inline constexpr auto known_schemes = detail::entries_of(static_cast<const all_schemes*>(nullptr));
using any_scheme = decltype(detail::variant_of(static_cast<const all_schemes*>(nullptr)));

/// What the command line says about the form of a scheme; empty: nothing.
struct scheme_words {
    std::string preset;
    std::string boundary_corners;
    std::string weights;
    std::string boundary;
    std::string crease_method;
    std::optional<double> crease_angle;
    std::optional<double> crease_sharpness;
    std::optional<double> tension;
    std::optional<int> degree;
    bool ignore_tags = false;
    bool triangulate = false;
};

/// Edges and vertices of the control mesh.
struct sharp_elements {
    std::size_t edges = 0, vertices = 0;

    [[nodiscard]] bool any() const { return edges != 0 or vertices != 0; }
};

/// Those that are sharp for more levels than this; averages of neighbours (Chaikin) may end that earlier.
sharp_elements sharp_after(const any_scheme& scheme, int levels);

/// Adds to what goes along with the mesh what the next step of the scheme would read of the last level, or names it as
/// lost.
void tell_next_step(control_mesh& control, const any_scheme& scheme, int levels);

/// "catmull-clark and loop"
std::string schemes_with_creases();

/// Whether texture coordinates may be other than linear in faces: with creases, and where nothing else is, too.
bool refines_along_seams(const any_scheme& scheme);

/// What of a scheme's creases and boundary the tags of an OBJ file have to say besides the sharp elements.
void add_boundary_tag(io::mesh_tags& tags, const any_scheme& scheme);
/// Adds the rule of corners at the boundary to what is lost, where the input said one that is not the default of the
/// scheme, for faces that stay.
void add_lost_boundary_rule(std::vector<std::string>& lost, const io::mesh_tags& given, const any_scheme& scheme);

/// Errors: usage_error for a name that is not known, and for words that this scheme does not take.
any_scheme make_scheme(const std::string& name, const scheme_words& words);

/// Cuts the faces of a control mesh into triangles where the words ask for it, and tells the scheme of its creases:
/// those of the file, and edges sharper than the angle.
/// Tags that mean something else are noted on standard error; where tags are to be ignored, the mesh has none then. The
/// rule of the file for corners at the boundary, if it counts, is a word then: for who has not read the file.
/// Errors: mesh_error for tags that do not fit the mesh, and for creases and holes if the scheme has no rules for them.
void give_creases(any_scheme& scheme, control_mesh& control, scheme_words& words);

/// Refuses a mesh that the scheme does not take, with what the programs have to make it one. Errors: mesh_error.
void require_scheme_takes(const any_scheme& scheme, const basic_mesh<>& control);

/// The mesh that the scheme starts from, with its attributes: the control mesh itself, except for 4-8.
basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control, attribute_fields& attributes);
basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control);

/// Whether that is another mesh.
bool is_prepared(const any_scheme& scheme);

/// "catmull-clark, loop, ..."
std::string scheme_names();

/// The schemes that take a mesh as it is, with the creases and holes of its file. Precondition: the tags fit the mesh.
std::vector<std::string_view> schemes_that_take(const control_mesh& control);

/// "unified is not refined in tiles: ...", of a scheme that is not.
std::string not_in_tiles(std::string_view scheme);

} // namespace kith::tool
