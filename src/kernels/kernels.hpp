// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "hapticut/force/law.hpp"
#include "hapticut/force/resultant.hpp"
#include "hapticut/tool/head.hpp"
#include "hapticut/workpiece/contact.hpp"

/// @file
/// The stages that work on one block, in the widest vector instructions of the machine, chosen when the program starts.
/// They compute what the scalar functions of the same names in the public headers compute, within rounding: those are
/// the reference that tests hold them against, and what runs where the library was built without Highway.
namespace hapticut::kernels {

/// Stage `sample_contact` for any head.
void sample_contact(const ToolHead& head, const BlockView& block, const GridInHead& grid, Quadrature quadrature,
                    ContactBlock& out) noexcept;

/// Stage `evaluate_law` of FoundationLaw.
LawTotals evaluate_foundation(const HeadMotion& motion, const ContactMaterials& materials,
                              ContactBlock& block) noexcept;

/// Stage `sum_resultant`.
void sum_resultant(const ContactBlock& block, Resultant& total) noexcept;

}  // namespace hapticut::kernels
