// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "strategy_costs.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace kith {

/// The origin of the template of a class of faces, if it has one.
enum class template_choice : unsigned char { none, made, kept };

/// An estimate of the cost of a level that is made patch by patch. The unit is the cost of a final face made level by
/// level.
class patch_estimate {
public:
    /// Takes the sizes of the classes. Their patches have faces only, or all connectivity (`with_edges`).
    patch_estimate(const strategy_costs& costs, const patch_sizes& sizes, std::vector<std::size_t> of_classes,
                   bool with_edges)
        : costs_(costs)
        , of_classes_(std::move(of_classes))
        , of_patch_(sizes.faces_of_patch)
        , in_patch_(with_edges ? costs.in_patch_with_edges : costs.in_patch)
        , of_template_(costs.of_template + costs.of_face_in_template * of_patch_)
    {
    }

    /// Returns true if making a template for a class costs less than refining its faces without one.
    [[nodiscard]] bool gains(std::size_t of_class) const
    {
        return alone(of_class) > filled(of_class) + of_template_ + costs_.of_class_again;
    }
    /// Returns true if patches are cheaper than going level by level, when each class takes the cheaper way and no
    /// template is kept yet.
    [[nodiscard]] bool is_gain_without_kept() const
    {
        std::vector<template_choice> choices(of_classes_.size(), template_choice::none);
        for (std::size_t c = 0; c < of_classes_.size(); ++c)
            if (gains(c))
                choices[c] = template_choice::made;
        return is_gain(choices);
    }
    /// Returns true if patches are cheaper than going level by level, with these choices for the classes.
    [[nodiscard]] bool is_gain(std::span<const template_choice> choices) const
    {
        double cost = 0, faces = 0;
        for (std::size_t c = 0; c < of_classes_.size(); ++c) {
            if (of_classes_[c] == 0)
                continue;
            cost += choices[c] == template_choice::none ? alone(c) : filled(c) + costs_.of_class_again;
            cost += choices[c] == template_choice::made ? of_template_ : 0;
            faces += double(of_classes_[c]) * of_patch_;
        }
        return cost <= costs_.to_be_cheaper * faces;
    }

private:
    /// Returns the cost of the patches of a class without a template.
    [[nodiscard]] double alone(std::size_t of_class) const
    {
        return double(of_classes_[of_class]) * of_patch_ * costs_.among_few;
    }
    /// Returns the cost of filling the patches of a class from its template.
    [[nodiscard]] double filled(std::size_t of_class) const
    {
        return std::max(double(of_classes_[of_class]), costs_.least_of_class) * of_patch_ * in_patch_;
    }

    strategy_costs costs_;
    std::vector<std::size_t> of_classes_;
    double of_patch_, in_patch_, of_template_;
};

} // namespace kith
