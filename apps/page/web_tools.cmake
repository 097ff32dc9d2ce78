# SPDX-License-Identifier: Apache-2.0
# Finds the tools that build the page: HAPTICUT_NPM and HAPTICUT_NODE.
find_program(HAPTICUT_NPM npm)
find_program(HAPTICUT_NODE NAMES node nodejs)
mark_as_advanced(HAPTICUT_NPM HAPTICUT_NODE)
