// The maps of several meshes of one file, written at once.  Role: what Session::write is for one mesh, in time linear in
// their number.
#pragma once

#include "hgp/api/session.h"

namespace hgp::api {

/// WrittenMap::notes are about the file as a whole.
struct WrittenFile : WrittenMap {
  std::vector<Notes> mapNotes;  ///< by map, in the order of add()
};

/// One thread at a time may use it. It may outlive the session.
class FileMaps {
 public:
  /// The options of the file, and of all maps that have none of their own; WriteOptions::format is kSame.
  explicit FileMaps(WriteOptions options);
  ~FileMaps();
  FileMaps(FileMaps&&) noexcept;
  FileMaps& operator=(FileMaps&&) noexcept;

  /// Keeps the result of the session, which has taken one mesh of the file by load() or choose(); other sessions may have
  /// read the same file. Fails with kNoMap for a map that is not certified unless the options allow it, and with kUsage
  /// without a result.
  Status add(const Session& session);
  /// @param own  options of this map; of the file are the others
  Status add(const Session& session, const WriteOptions& own);
  bool isEmpty() const;
  /// The file with the maps. Fails with kUsage if they are not of different meshes of one file.
  Result<WrittenFile> write() const;

 private:
  struct Kept;
  WriteOptions options_;
  std::vector<Kept> kept_;
};

}  // namespace hgp::api
