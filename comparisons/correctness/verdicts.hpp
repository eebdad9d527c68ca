// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <kith/core/mesh/basic_mesh.hpp>
#include <kith/polygon_soup.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kith::comparison {

/// A control mesh that kith accepts.
struct control_mesh {
    std::string name;
    basic_mesh<> mesh;

    [[nodiscard]] bool is_triangles() const { return mesh.topology().degree == 3; }
    [[nodiscard]] bool is_closed() const { return mesh.corner_count() == 2 * mesh.edge_count(); }
    /// Returns the diagonal of the bounding box.
    [[nodiscard]] double diagonal() const;
};

/// A refinement of a control mesh by one of kith's ways.
struct result {
    std::string way;
    io::polygon_soup soup;
};

[[nodiscard]] io::polygon_soup soup_of(const basic_mesh<>& mesh);

/// The results of comparisons, which are printed line by line and summed up.
class verdicts {
public:
    static constexpr double rounding = 1e-12;

    void skip(std::string_view mesh, std::string_view scheme, std::string_view why);
    /// Compares results with the expected mesh. Coordinates may differ by `tolerance` times the diagonal of the control
    /// mesh.
    void compare(const control_mesh& control, std::string_view scheme, const io::polygon_soup& expected,
                 const std::vector<result>& found, double tolerance = rounding);
    /// Reports a result that agrees. `distance` is relative to the diagonal of the control mesh.
    void same(std::string_view mesh, std::string_view scheme, std::string_view what, double distance);
    void different(std::string_view mesh, std::string_view scheme, std::string_view what);

    /// Prints the sums. Returns true if nothing differs.
    [[nodiscard]] bool summary() const;

private:
    struct sums {
        std::size_t same = 0, different = 0;
        double worst = 0;
        std::string worst_mesh;
    };

    std::map<std::string, sums, std::less<>> by_scheme_;
    std::map<std::string, std::size_t, std::less<>> skipped_; // by reason
};

} // namespace kith::comparison
