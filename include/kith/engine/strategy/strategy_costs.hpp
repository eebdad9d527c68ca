// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "strategy.hpp"

#include <kith/core/mesh/connect.hpp>

#include <limits>

namespace kith {

/// The sizes of the patches that the last steps of a refinement would make.
struct patch_sizes {
    double faces;          ///< of the last level
    double faces_of_patch; ///< of the last level, for a face that owns a patch
    int rings;             ///< around such a face, on which its patch depends
};

/// The costs from which a strategy follows. The unit is the time that a final face takes level by level. They were
/// measured with the schemes of the library.
struct strategy_costs {
    // A final face in patches.
    double in_patch = .45;           ///< .3 (Butterfly) to .6
    double in_patch_with_edges = .5; ///< with all connectivity: .5 (Butterfly) to .8 (Loop)
    double among_few = 15;           ///< of a few faces refined with their rings, without a template: 12 to 70
    // Templates and classes.
    double of_template = 600;        ///< of making one: half of what it takes, since templates are kept
    double of_face_in_template = 20; ///< the same per face of its patch: small patches gain more by templates
    double of_look = 3;              ///< of finding the class of a face, per ring
    double of_class_again = 0;       ///< of finding the template of a class where levels are made again
    double least_of_classes = 16;    ///< kept templates are looked up if classes have as many faces on average
    double least_of_class = 1;       ///< filling fewer faces of a class takes as long as filling so many
    // Bounds.
    double most_of_looks = .4;    ///< classes are not looked for if that costs more than this share of the whole
    double share_if_alike = .3;   ///< most classes per face of a sample of a control mesh with alike faces
    double to_be_cheaper = .9;    ///< patches must cost at most this share of level by level
    double least_if_late = 12;    ///< smaller patches do not gain if they begin late because of unlike faces
    double least_if_ordered = 32; ///< smaller patches do not gain on the order of the surface alone, faces only
    double least_if_ordered_with_edges = 16; ///< the same with all connectivity
    double least_faces = 12e6;       ///< of the last level times those of a patch, to look for classes by one ring
    double least_faces_again = .8e6; ///< the same if such levels were made without templates again and again
    double least_faces_if_scattered = 40e6;         ///< the same if faces lie in no order and cannot be put into one
    double least_faces_to_order = 200e3;            ///< of the last level, for the order of the surface without patches
    double least_faces_to_order_with_edges = 750e3; ///< the same with all connectivity, written in scattered places

    /// Returns the costs for a caller that has no other way than patches: these always count as a gain. Each class of
    /// some faces is worth a template.
    [[nodiscard]] static constexpr strategy_costs without_choice()
    {
        strategy_costs result;
        result.to_be_cheaper = std::numeric_limits<double>::infinity();
        return result;
    }
    /// Returns the costs for levels whose points are made again and again. A template pays if it saves more than a few
    /// evaluations of the faces of its class.
    [[nodiscard]] static constexpr strategy_costs of_evaluations()
    {
        return {.in_patch = .2, .of_template = 100, .of_face_in_template = 5, .to_be_cheaper = .5, .least_faces = 1};
    }
    /// Returns costs with which there are patches wherever there can be, and a template for every class of faces.
    [[nodiscard]] static constexpr strategy_costs of_templates_for_all()
    {
        strategy_costs result = without_choice();
        result.in_patch = result.of_template = result.of_face_in_template = result.of_look = 0;
        result.among_few = result.share_if_alike = 1; // for any control mesh
        result.least_if_late = result.least_if_ordered = result.least_if_ordered_with_edges = 1;
        result.least_faces = result.least_faces_if_scattered = 1;
        return result;
    }
    /// Returns the faces of the last level below which classes are not looked for. More rings tell more classes apart.
    [[nodiscard]] double least_to_look(const patch_sizes& sizes) const
    {
        return least_faces / sizes.faces_of_patch * (1 + sizes.rings) / 2;
    }
    /// Returns the faces of the last level below which the order of the surface alone is no gain.
    [[nodiscard]] double least_to_order(connect last_level) const
    {
        return last_level == connect::faces ? least_faces_to_order : least_faces_to_order_with_edges;
    }

    /// Returns the costs for a control mesh whose faces are unlike and lie in no order. There, going level by level
    /// takes two to three times as long, and looking reads from all over the memory. Making a template does not take
    /// longer. If patches begin late for that reason, there is much to look at, and there are many classes.
    [[nodiscard]] strategy_costs if_unlike(bool is_late) const
    {
        strategy_costs costs = *this;
        if (is_late)
            costs.least_faces *= 8;
        costs.of_template /= 2;
        costs.of_face_in_template /= 2;
        return costs;
    }
    /// Returns the costs for levels that are made `times` times, with templates that are made once. Such levels have
    /// few faces, or templates were no gain for them before.
    [[nodiscard]] strategy_costs if_again(double times) const
    {
        strategy_costs costs = *this;
        costs.of_template /= times;
        costs.of_face_in_template /= times;
        costs.of_class_again = 250;
        return costs;
    }
    /// Returns the costs for a tile. Level by level, a tile takes several times as long as a mesh: it refines faces of
    /// other tiles, too, and cuts them off after each step. The output of patches is copied once. A template serves
    /// `sharing` tiles on average.
    [[nodiscard]] strategy_costs if_in_tiles(double sharing) const
    {
        constexpr double times_as_long = 6;
        strategy_costs costs = if_again(sharing);
        for (double* cost : {&costs.in_patch,
                             &costs.among_few,
                             &costs.of_template,
                             &costs.of_face_in_template,
                             &costs.of_class_again,
                             &costs.least_of_classes})
            *cost /= times_as_long;
        costs.in_patch *= 2;
        costs.least_of_class = 8; // as many as most processors have lanes for
        return costs;
    }
};

/// Returns these costs, or those of templates for all if patches are forced.
inline strategy_costs usual_costs(const strategy_costs& usual = {})
{
    return forced_way() == refinement_way::in_patches ? strategy_costs::of_templates_for_all() : usual;
}
/// Returns true if another way than patches is forced.
inline bool are_patches_ruled_out()
{
    const auto way = forced_way();
    return way and * way != refinement_way::in_patches;
}

} // namespace kith
