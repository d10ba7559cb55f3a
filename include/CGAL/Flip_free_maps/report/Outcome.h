// Copyright (c) 2026 The Flip_free_maps authors.
// This file is part of Flip_free_maps, a CGAL-style package.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Flip_free_maps authors

#ifndef CGAL_FLIP_FREE_MAPS_REPORT_OUTCOME_H
#define CGAL_FLIP_FREE_MAPS_REPORT_OUTCOME_H

#include <CGAL/Flip_free_maps/report/Status.h>
#include <CGAL/Flip_free_maps/report/internal/Field_writers.h>

#include <ostream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Flip_free_maps {

/// \ingroup PkgFlipFreeMapsRef
/// How a function of this package ended: what all accounts begin with.
///
/// An account names its fields, once, in `for_each_field(visit)`, which calls `visit(name, value)` or
/// `visit(name, value, Field_role::detail)` for each. JSON and text are made from that.
struct Outcome
{
  Status status = Status::invalid_option; ///< how it ended
  std::string message = "not run";        ///< a sentence that says why

  Outcome() = default;

  /// With a status and a sentence.
  Outcome(Status status, std::string message) : status(status), message(std::move(message)) {}

  /// `true` when the caller's property map, or array, holds a result. It is untouched otherwise.
  bool is_valid() const { return is_valid_map(status); }

  /// `true` when nothing was left undone: neither failure nor limit.
  bool is_success() const { return status == Status::success; }

  /// Calls `visit(name, value)` for each field.
  template <typename Visitor>
  void for_each_field(Visitor&& visit) const
  {
    visit("status", status, Field_role::detail);
    visit("message", message, Field_role::detail);
  }
};

/// \ingroup PkgFlipFreeMapsRef
/// Fills a JSON value with all fields of an account. Written against the interface of nlohmann::json, which finds this function
/// by argument-dependent lookup: `nlohmann::json j = summary;`. Numbers that are not finite are `null` in the text of nlohmann::json.
///
/// \tparam Account an `Outcome`, or a part of one that has `for_each_field()`
template <typename Json, typename Account, std::enable_if_t<internal::Has_fields<Account>::value, int> = 0>
void to_json(Json& json, const Account& account)
{
  json = Json::object();
  account.for_each_field(internal::Json_fields<Json>(json));
}

/// \ingroup PkgFlipFreeMapsRef
/// Writes an account as a few lines of text.
template <typename Account, std::enable_if_t<std::is_base_of_v<Outcome, Account>, int> = 0>
std::ostream& operator<<(std::ostream& os, const Account& account)
{
  os << account.status << ": " << account.message << '\n';
  internal::Text_fields text(os);
  account.for_each_field(text);
  text.end_line();
  return os;
}

} // namespace Flip_free_maps
} // namespace CGAL

#endif // CGAL_FLIP_FREE_MAPS_REPORT_OUTCOME_H
