// SPDX-License-Identifier: BSD-3-Clause
#include <kith/catmull_clark.hpp>
#include <kith/fields/with_fields.hpp>
#include <kith/tiles/output/file_array.hpp>

#include <vector>

int main()
{
    const auto scheme = kith::with_fields(kith::catmull_clark{}, kith::on_corners(std::vector<double>()));
    return int(kith::arrays_of<decltype(scheme)>(kith::field_named<0>("uv")).size());
}
