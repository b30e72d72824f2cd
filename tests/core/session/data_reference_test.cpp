#include "core/session/file/data_reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/core/session/recorded_session.hpp"

namespace abrazo::data_reference_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::Pair;
using testing::UnorderedElementsAre;
using State = FoundData::State;
using Use = DataReference::Use;

class DataReferences : public testing::Test {
 protected:
  std::string put(const std::string& name, const std::string& content) {
    const std::string path = folder.file(name);
    fs::create_directories(fs::path(path).parent_path());
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    return path;
  }
  DataReference reference(const std::string& path, Use use = Use::Motion) {
    auto made = reference_to(path, use, session);
    EXPECT_TRUE(made);
    return *made;
  }
  test::TemporaryFolder folder;
  std::string session = folder.file("sessions/s.abrazo");
};

TEST_F(DataReferences, NameAFileRelativeToTheSessionWithItsContent) {
  const DataReference made = reference(put("data/lib.h5", "pairs"), Use::Library);
  EXPECT_EQ(made.use, Use::Library);
  EXPECT_EQ(made.relative_path, "../data/lib.h5");
  EXPECT_EQ(made.absolute_path, folder.file("data/lib.h5"));
  EXPECT_EQ(made.bytes, 5U);
  EXPECT_EQ(made.hash.size(), 16U);
  EXPECT_EQ(reference(put("other/copy.h5", "pairs")).hash, made.hash);
  EXPECT_NE(reference(put("other/copy.h5", "pairt")).hash, made.hash);
  EXPECT_NE(reference(put("other/copy.h5", std::string("pairs\0", 6))).hash, made.hash);
  EXPECT_FALSE(reference_to(folder.file("nothing.h5"), Use::Library, session));
  EXPECT_FALSE(reference_to(folder.file("data"), Use::Library, session));
}

TEST_F(DataReferences, AreFoundBesideTheSessionWhenBothMoved) {
  const DataReference made = reference(put("data/lib.h5", "pairs"));
  fs::create_directories(folder.file("moved/sessions"));
  fs::rename(folder.file("data"), folder.file("moved/data"));
  const FoundData found = find_data(made, folder.file("moved/sessions/s.abrazo"));
  EXPECT_EQ(found.state, State::Found);
  EXPECT_EQ(found.path, folder.file("moved/data/lib.h5"));
}

TEST_F(DataReferences, AreFoundWhereTheyWereWhenOnlyTheSessionMoved) {
  const DataReference made = reference(put("data/lib.h5", "pairs"));
  const FoundData found = find_data(made, folder.file("far/away/deep/s.abrazo"));
  EXPECT_EQ(found.state, State::Found);
  EXPECT_EQ(found.path, folder.file("data/lib.h5"));
}

TEST_F(DataReferences, WithOtherContentAreFoundAndSaidToBeChanged) {
  const DataReference made = reference(put("data/lib.h5", "pairs"));
  put("data/lib.h5", "PAIRS");
  EXPECT_EQ(find_data(made, session).state, State::Changed);
  EXPECT_EQ(find_data(made, session).path, folder.file("data/lib.h5"));
  put("data/lib.h5", "more pairs");
  EXPECT_EQ(find_data(made, session).state, State::Changed);
}

TEST_F(DataReferences, TakeTheOneOfTheSameContentWhereTwoAreThere) {
  const DataReference made = reference(put("data/lib.h5", "pairs"));
  put("elsewhere/data/lib.h5", "another");
  const FoundData found = find_data(made, folder.file("elsewhere/sessions/s.abrazo"));
  EXPECT_EQ(found.state, State::Found);
  EXPECT_EQ(found.path, folder.file("data/lib.h5"));
}

TEST_F(DataReferences, ThatAreMissingSayWhereTheyWereLookedFor) {
  const DataReference made = reference(put("data/lib.h5", "pairs"));
  fs::remove_all(folder.file("data"));
  const FoundData found = find_data(made, folder.file("elsewhere/sessions/s.abrazo"));
  EXPECT_EQ(found.state, State::Missing);
  EXPECT_EQ(found.path, "");
  EXPECT_THAT(found.looked, ElementsAre(folder.file("elsewhere/data/lib.h5"), folder.file("data/lib.h5")));
}

TEST_F(DataReferences, OfALargeFileBeginMiddleAndEndAreCompared) {
  const std::string path = put("big.bin", "");
  fs::resize_file(path, std::uintmax_t{65} << 20);  // a hole: takes no place on the disk
  const DataReference made = reference(path);
  const auto poke = [&](std::uint64_t at) {
    std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file.put('x');
  };
  poke((std::uint64_t{65} << 20) - 1);
  EXPECT_EQ(find_data(made, session).state, State::Changed);
  EXPECT_EQ(find_data(reference(path), session).state, State::Found);
}

TEST_F(DataReferences, OneThatWasPointedOutFindsTheOthersOfTheSameMove) {
  const std::vector<DataReference> data = {
      reference(put("old/data/libs/lib.h5", "1"), Use::Library), reference(put("old/data/user.bvh", "2")),
      reference(put("old/data/video/a.mp4", "3"), Use::Video), reference(put("stays/here.bvh", "4"))};
  fs::create_directories(folder.file("far/new"));
  fs::rename(folder.file("old/data"), folder.file("far/new/place"));
  fs::remove(folder.file("far/new/place/video/a.mp4"));
  EXPECT_THAT(relocated(data, 0, folder.file("far/new/place/libs/lib.h5")),
              UnorderedElementsAre(Pair(1U, folder.file("far/new/place/user.bvh"))));
  EXPECT_THAT(relocated(data, 1, folder.file("far/new/place/user.bvh")),
              UnorderedElementsAre(Pair(0U, folder.file("far/new/place/libs/lib.h5"))));
  EXPECT_TRUE(relocated(data, 9, folder.file("far/new/place/user.bvh")).empty());
}

}  // namespace
}  // namespace abrazo::data_reference_test
