#include "core/session/file/project_schema.hpp"

namespace abrazo {

const char* const project_tables = R"sql(
CREATE TABLE project (id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, value TEXT NOT NULL);
CREATE TABLE view_state (id INTEGER PRIMARY KEY, key TEXT NOT NULL UNIQUE, value TEXT NOT NULL);
CREATE TABLE data_references (
  id INTEGER PRIMARY KEY, use TEXT NOT NULL, relative_path TEXT, absolute_path TEXT NOT NULL,
  bytes INTEGER NOT NULL, hash TEXT NOT NULL);
CREATE TABLE subjects (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, next_number INTEGER NOT NULL);
CREATE TABLE tiers (
  id INTEGER PRIMARY KEY, subject INTEGER NOT NULL REFERENCES subjects, number INTEGER NOT NULL,
  kind TEXT NOT NULL, name TEXT NOT NULL);
CREATE TABLE vocabularies (
  id INTEGER PRIMARY KEY, tier INTEGER NOT NULL REFERENCES tiers, value TEXT NOT NULL, description TEXT NOT NULL,
  rgb INTEGER, key TEXT);
CREATE TABLE annotations (
  id INTEGER PRIMARY KEY, tier INTEGER NOT NULL REFERENCES tiers, number INTEGER NOT NULL, start_s REAL NOT NULL,
  end_s REAL NOT NULL, value TEXT NOT NULL, detail TEXT NOT NULL, confidence TEXT NOT NULL);
CREATE TABLE suggestions (
  id INTEGER PRIMARY KEY, tier INTEGER NOT NULL REFERENCES tiers, number INTEGER NOT NULL, start_s REAL NOT NULL,
  end_s REAL NOT NULL, value TEXT NOT NULL, confidence REAL NOT NULL, reason TEXT NOT NULL);
CREATE TABLE videos (
  id INTEGER PRIMARY KEY, data INTEGER REFERENCES data_references, subject TEXT NOT NULL, rate REAL NOT NULL);
CREATE TABLE sync_points (
  id INTEGER PRIMARY KEY, video INTEGER NOT NULL REFERENCES videos, subject_s REAL NOT NULL, video_s REAL NOT NULL);
CREATE TABLE cameras (
  id INTEGER PRIMARY KEY, video INTEGER NOT NULL REFERENCES videos, width INTEGER NOT NULL, height INTEGER NOT NULL,
  fx REAL NOT NULL, fy REAL NOT NULL, cx REAL NOT NULL, cy REAL NOT NULL,
  k1 REAL NOT NULL, k2 REAL NOT NULL, p1 REAL NOT NULL, p2 REAL NOT NULL,
  k3 REAL NOT NULL, k4 REAL NOT NULL, k5 REAL NOT NULL, k6 REAL NOT NULL,
  r11 REAL NOT NULL, r12 REAL NOT NULL, r13 REAL NOT NULL, r21 REAL NOT NULL, r22 REAL NOT NULL, r23 REAL NOT NULL,
  r31 REAL NOT NULL, r32 REAL NOT NULL, r33 REAL NOT NULL, tx REAL NOT NULL, ty REAL NOT NULL, tz REAL NOT NULL);
CREATE TABLE picked_points (
  id INTEGER PRIMARY KEY, video INTEGER NOT NULL REFERENCES videos, x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL,
  pixel_x REAL NOT NULL, pixel_y REAL NOT NULL, subject_s REAL NOT NULL, vertex INTEGER);
CREATE VIEW annotation_list AS
  SELECT s.name AS subject, t.name AS tier, t.kind, a.start_s, a.end_s, a.value, a.detail, a.confidence
  FROM annotations a JOIN tiers t ON t.id = a.tier JOIN subjects s ON s.id = t.subject
  ORDER BY s.name, t.id, a.start_s;
)sql";

}  // namespace abrazo
