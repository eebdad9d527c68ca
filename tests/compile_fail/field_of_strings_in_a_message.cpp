// SPDX-License-Identifier: BSD-3-Clause
// Values of a field that are no plain bytes.
#include <kith/fields/field.hpp>
#include <kith/tiles/refine/pack.hpp>

#include <string>

void send(kith::packer& out, const kith::field<kith::field_on::faces, std::string, kith::from_parent<>>& names)
{
    names.pack(out);
}
