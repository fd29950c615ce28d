"""Every kind of background work: importing a module registers its handler."""

import sightline.demo.demo_job
import sightline.demo.study_job
import sightline.export.export_job
import sightline.poses.pose_job
import sightline.quality.drift.drift_job
import sightline.recordings.calibrating.calibrate_job
import sightline.recordings.ingest_job
import sightline.scans.again.again_job
import sightline.scans.read_job
import sightline.scans.vehicles.find_job
import sightline.studies.study_job
import sightline.vehicles.passes.find_job
import sightline.vehicles.proposing.propose_job

MODULES = (
    sightline.recordings.calibrating.calibrate_job,
    sightline.demo.demo_job,
    sightline.demo.study_job,
    sightline.export.export_job,
    sightline.scans.again.again_job,
    sightline.poses.pose_job,
    sightline.quality.drift.drift_job,
    sightline.recordings.ingest_job,
    sightline.scans.read_job,
    sightline.scans.vehicles.find_job,
    sightline.studies.study_job,
    sightline.vehicles.passes.find_job,
    sightline.vehicles.proposing.propose_job,
)
