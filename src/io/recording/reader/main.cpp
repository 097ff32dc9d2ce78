// SPDX-License-Identifier: Apache-2.0
// Program that reads recordings for the library. It replies to queries about one HDF5 file.
#include <memory>
#include <string>

#include "io/child_side.hpp"
#include "io/recording/hdf5_source.hpp"

// NOLINTNEXTLINE(bugprone-exception-escape): it ends this program, and the library reports a damaged file
int main() {
  using namespace hapticut;
  std::unique_ptr<Hdf5Source> source;
  const auto answer = [&](const std::string& request) {
    const Query query = query_in(request);
    if (query.kind == QueryKind::open) source = open_hdf5_file(query.place);
    if (source == nullptr) throw hdf5::Failure("no file is open");
    return source->reply_to(query);
  };
  child::serve(answer, [](const std::exception& error) {
    const auto* const failure = dynamic_cast<const hdf5::Failure*>(&error);
    return failure == nullptr ? Fault::part : failure->fault();
  });
}
