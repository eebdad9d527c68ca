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

/// A scheme that the program knows, and its source. The type of the scheme has its name, the faces that it takes and
/// its options.
template <class Scheme>
struct scheme_entry {
    std::string_view source;
    basic_mesh<> (*prepare)(const basic_mesh<>&,
                            attribute_fields&) = nullptr; ///< turns any mesh into one that the scheme can start from
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

/// The schemes of all verbs: those of the registry.
inline constexpr auto known_schemes = detail::entries_of(static_cast<const all_schemes*>(nullptr));
using any_scheme = decltype(detail::variant_of(static_cast<const all_schemes*>(nullptr)));

/// The words of the command line on the form of a scheme; members that are empty were not given.
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

/// The number of sharp edges and vertices of a control mesh.
struct sharp_elements {
    std::size_t edges = 0, vertices = 0;

    [[nodiscard]] bool any() const { return edges != 0 or vertices != 0; }
};

/// Returns the number of edges and vertices that are sharp for more than `levels` levels. Averages of neighbours
/// (Chaikin) may end their sharpness earlier.
sharp_elements sharp_after(const any_scheme& scheme, int levels);

/// Adds what the next step of the scheme would read of the last level to the attributes of the mesh, or to what is
/// lost.
void tell_next_step(control_mesh& control, const any_scheme& scheme, int levels);

/// Returns the names of the schemes with creases: "catmull-clark, loop and quad-tri".
std::string schemes_with_creases();

/// Returns true if texture coordinates need not be linear in faces, which holds for schemes with creases. It also holds
/// for linear schemes, in which everything is linear.
bool refines_along_seams(const any_scheme& scheme);

/// Adds the scheme's rule for boundary corners to the tags of an OBJ file, unless it is the default. The sharp elements
/// are added elsewhere.
void add_boundary_tag(io::mesh_tags& tags, const any_scheme& scheme);
/// Adds the rule for boundary corners to what is lost. Conditions: the input names a rule, the scheme's rule is not its
/// default, and the faces at the boundary are not holes.
void add_lost_boundary_rule(std::vector<std::string>& lost, const io::mesh_tags& given, const any_scheme& scheme);

/// Returns the scheme of this name, in the form that the words choose. Errors: usage_error for an unknown name, and for
/// words that this scheme does not take.
any_scheme make_scheme(const std::string& name, const scheme_words& words);

/// Cuts the faces of a control mesh into triangles if the words ask for it, and gives the scheme its creases: those of
/// the file, and edges sharper than the angle.
/// Tags that are not understood are noted on standard error. If the words say that tags are ignored, the mesh has none
/// afterwards. The rule of the file for boundary corners, if it counts, is stored in `words`, for ranks that have not
/// read the file.
/// Errors: mesh_error for tags that do not fit the mesh, and for creases and holes if the scheme has no rules for them.
void give_creases(any_scheme& scheme, control_mesh& control, scheme_words& words);

/// Throws mesh_error for a mesh that the scheme does not take. The message names the options or verbs of the programs
/// that make the mesh one that it takes.
void require_scheme_takes(const any_scheme& scheme, const basic_mesh<>& control);

/// Returns the mesh that the scheme starts from, with its attributes: the control mesh itself, except for 4-8.
basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control, attribute_fields& attributes);
basic_mesh<> prepared(const any_scheme& scheme, basic_mesh<> control);

/// Returns true if `prepared` returns another mesh than the control mesh.
bool is_prepared(const any_scheme& scheme);

/// Returns the names of all schemes: "catmull-clark, loop, ...".
std::string scheme_names();

/// Returns the names of the schemes that take a mesh as it is, with the creases and holes of its file. Precondition:
/// the tags fit the mesh.
std::vector<std::string_view> schemes_that_take(const control_mesh& control);

/// Returns the message on a scheme that is not refined in tiles: "unified is not refined in tiles: ...".
std::string not_in_tiles(std::string_view scheme, bool is_closed_only);

} // namespace kith::tool
